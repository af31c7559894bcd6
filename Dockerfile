# Image of the program with its data: docker build -t gurney . (or podman build), docs/install.md.
# Not tried yet: no container engine was at hand.
FROM docker.io/library/debian:12 AS build
WORKDIR /gurney
COPY dev ./
RUN ./dev setup
# With .git: the commit goes into every result.
COPY . .
# x86-64-v3 is faster, on a CPU with AVX2 only: --build-arg GURNEY_CPU=x86-64-v3
ARG GURNEY_CPU=generic
RUN cmake --preset release -DGURNEY_CPU="$GURNEY_CPU" -DGURNEY_TESTS=OFF -DGURNEY_BENCHMARKS=OFF \
  && ./dev install

FROM docker.io/library/debian:12-slim
# Libraries that the program loads; librsvg2-2 when it writes PDF and PNG.
RUN apt-get update -qq \
  && apt-get install -y -qq --no-install-recommends \
    libbullet3.24 \
    libfmt9 \
    libgcc-s1 \
    libgomp1 \
    libhdf5-103-1 \
    libhdf5-hl-100 \
    librsvg2-2 \
    libssl3 \
    libstdc++6 \
    libtomlplusplus3 \
  && rm -rf /var/lib/apt/lists/*
COPY --from=build /usr/local/bin/gurney /usr/local/bin/gurney
COPY --from=build /usr/local/share /usr/local/share
RUN gurney --version && gurney verify skid_to_roll
WORKDIR /data
ENTRYPOINT ["gurney"]
CMD ["--help"]
