package org.dronewatch.jmh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.dronewatch.geo.Origin;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.terrain.TerrainLoader;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.terrain.io.TiffFixture;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/**
 * From a GeoTIFF file of a million posts, 1 m apart and rough as ground seen by lidar, to a tree over its triangles.
 */
@State(Scope.Benchmark)
public class TerrainLoading extends FreshJvm {
    private static final int SIDE = 1000;
    private static final String FILE = "dem.tif";

    /** The greatest vertical error, m; 0 keeps every post. */
    @Param({"0.5", "0"})
    public double accuracy;

    private Path directory;

    /**
     * Writes the file: hills from octaves of waves, each half as long and half as high as the one before, and noise.
     */
    @Setup
    public void write() throws IOException {
        SplittableRandom random = new SplittableRandom(1);
        double[] heights = new double[SIDE * SIDE];
        for (int octave = 0; octave < 7; octave++) {
            double length = 500.0 / (1 << octave);
            double amplitude = 25.0 / (1 << octave);
            double turn = 2.0 * Math.PI * random.nextDouble();
            double phase = 2.0 * Math.PI * random.nextDouble();
            for (int i = 0; i < heights.length; i++) {
                double along = (i % SIDE * Math.cos(turn) + i / SIDE * Math.sin(turn)) / length;
                double across = (i / SIDE * Math.cos(turn) - i % SIDE * Math.sin(turn)) / length;
                heights[i] += amplitude * Math.sin(2.0 * Math.PI * along + phase) * Math.cos(2.0 * Math.PI * across);
            }
        }
        for (int i = 0; i < heights.length; i++) {
            heights[i] += 300.0 + 0.1 * random.nextDouble();
        }
        TiffFixture file = new TiffFixture(SIDE, SIDE, heights);
        file.compression = 8;
        file.predictor = 3;
        file.tile = 256;
        file.scale = new double[] {1, 1, 0};
        file.tie = new double[] {0, 0, 0, 458_000, 5_548_200, 0};
        directory = Files.createTempDirectory("terrain");
        Files.write(directory.resolve(FILE), file.bytes());
    }

    /** Removes the file. */
    @TearDown
    public void remove() throws IOException {
        Files.delete(directory.resolve(FILE));
        Files.delete(directory);
    }

    /** Reads, decimates and builds, as the first run of a scene does. */
    @Benchmark
    public KDTree load() {
        TerrainSettings settings = TerrainSettings.of(FILE).withAccuracy(accuracy);
        Origin origin = Origin.at(Math.toRadians(50.08), Math.toRadians(14.42));
        return KDTree.of(
                new TerrainLoader(directory, line -> {}).load(settings, origin).mesh());
    }
}
