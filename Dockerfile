# Images of Debian 12 from the package list scripts/packages.txt:
#   docker build -t argos3-sim .                     the simulator, installed from its own Debian packages
#   docker run --rm -v "$PWD":/work argos3-sim -c /usr/share/argos3/experiments/diffusion_10.argos
#   docker run --rm -v "$PWD":/work --entrypoint argos3-campaign argos3-sim run campaign.xml
#   docker build -t argos3-sim-dev --target dev .    what building, testing and packaging need, for .devcontainer/
FROM debian:12 AS dev
WORKDIR /src
# only these two files, so that the layer is rebuilt only if they change
COPY scripts/setup.sh scripts/packages.txt scripts/
RUN apt-get update && scripts/setup.sh run test site package && rm -rf /var/lib/apt/lists/*

FROM debian:12 AS packages
WORKDIR /src
COPY scripts/setup.sh scripts/packages.txt scripts/
RUN apt-get update && scripts/setup.sh run package && rm -rf /var/lib/apt/lists/*
COPY . .
RUN scripts/package.sh /packages deb

FROM debian:12
COPY --from=packages /packages/*.deb /packages/
RUN apt-get update && \
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends /packages/*.deb ffmpeg gnuplot-nox && \
    rm -rf /packages /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["argos3"]
CMD ["--help"]
