package org.dronewatch.report.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.dronewatch.geo.MapPoint;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.map.GeoTiff.CellClass;
import org.dronewatch.terrain.io.ElevationFile;
import org.dronewatch.terrain.io.ElevationFiles;
import org.dronewatch.terrain.io.Window;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Written grids, read by the reader of terrains and by that of TwelveMonkeys. */
class GeoTiffTest {
    @TempDir
    private Path directory;

    private static Origin origin(double latitude, double longitude) {
        return new Origin(Math.toRadians(latitude), Math.toRadians(longitude), Optional.of(120.0));
    }

    private ElevationFile read(String name) {
        return new ElevationFiles(directory).open(name);
    }

    /** Monaco, the south, near the edges of zones, the date line and both poles. */
    @ParameterizedTest
    @CsvSource({
        "43.7314, 7.4202, EPSG:32632",
        "-33.9, 18.4, EPSG:32734",
        "52.0, 5.999, EPSG:32631",
        "52.0, 6.0, EPSG:32632",
        "0.0, -180.0, EPSG:32601",
        "60.0, 179.99, EPSG:32660",
        "84.5, 20.0, EPSG:32661",
        "-89.0, 20.0, EPSG:32761"
    })
    void cellsAreWhereTheyAreOnEarth(double latitude, double longitude, String crs) throws IOException {
        for (double side : new double[] {10_000.0, 100_000.0}) {
            int columns = 40;
            double cell = side / columns;
            Origin origin = origin(latitude, longitude);
            new GeoTiff(origin, 300.0, -200.0, cell, columns)
                    .writeNumbers(directory.resolve("place.tif"), new float[columns * columns]);
            ElevationFile file = read("place.tif");
            assertThat(file.crs().orElseThrow().name()).isEqualTo(crs);
            assertThat(file.columns()).isEqualTo(columns);
            assertThat(file.rows()).isEqualTo(columns);
            MapTransform transform = new MapTransform(file.crs().get(), origin);
            double farthest = 0.0;
            for (int row = 0; row < columns; row++) {
                for (int column = 0; column < columns; column++) {
                    MapPoint exact = transform.onMap(new Position(
                            300.0 + (column + 0.5 - columns / 2.0) * cell,
                            -200.0 - (row + 0.5 - columns / 2.0) * cell,
                            0.0));
                    farthest = Math.max(
                            farthest,
                            Math.hypot(
                                    file.lattice().xAt(column, row) - exact.x(),
                                    file.lattice().yAt(column, row) - exact.y()));
                }
            }
            // The smallest possible cell of a grid of 100 km is 50 m.
            assertThat(farthest).as("side %s", side).isLessThan(side > 50_000.0 ? 25.0 : 0.3);
        }
    }

    /** Every cell is where it was, and what has no number is a hole. */
    @Test
    void numbersComeBack() throws IOException {
        int columns = 7;
        float[] cells = new float[columns * columns];
        for (int i = 0; i < cells.length; i++) {
            cells[i] = i % 5 == 3 ? Float.NaN : 0.37f * i;
        }
        new GeoTiff(origin(50, 15), 0, 0, 12.5, columns).writeNumbers(directory.resolve("numbers.tif"), cells);
        ElevationFile file = read("numbers.tif");
        assertThat(file.statesNodata()).isTrue();
        assertThat(file.heights(new Window(0, 0, columns, columns))).isEqualTo(cells);
        assertThat(cells[3]).as("not changed").isNaN();
    }

    @Test
    void countsComeBack() throws IOException {
        int[] cells = {0, 1, 2, 300, -1, 65_534, 70_000, 7, -5};
        new GeoTiff(origin(50, 15), 0, 0, 12.5, 3).writeCounts(directory.resolve("counts.tif"), cells);
        assertThat(read("counts.tif").heights(new Window(0, 0, 3, 3)))
                .containsExactly(0f, 1f, 2f, 300f, Float.NaN, 65_534f, 65_534f, 7f, Float.NaN);
    }

    /** Another library's reader shows them in their colours; their names are beside them. */
    @Test
    void classesHaveColoursAndNames() throws IOException {
        List<CellClass> classes = List.of(
                new CellClass("unknown", Color.WHITE),
                new CellClass("too weak", new Color(0xf0e442)),
                new CellClass("detected", new Color(0x9fd3f2)));
        byte[] cells = {0, 1, 2, 2, 1, 0, (byte) GeoTiff.NO_CLASS, 1, 1};
        Path file = directory.resolve("classes.tif");
        new GeoTiff(origin(50, 15), 0, 0, 12.5, 3).writeClasses(file, cells, classes);
        BufferedImage image = readByTwelveMonkeys(file);
        for (int i = 0; i < cells.length; i++) {
            assertThat(image.getRaster().getSample(i % 3, i / 3, 0)).isEqualTo(cells[i] & 0xff);
            if (cells[i] >= 0) {
                assertThat(new Color(image.getRGB(i % 3, i / 3)))
                        .isEqualTo(classes.get(cells[i]).colour());
            }
        }
        assertThat(read("classes.tif").heights(new Window(0, 2, 3, 1))).containsExactly(Float.NaN, 1f, 1f);
        assertThat(Files.readString(directory.resolve("classes.tif.aux.xml")))
                .containsSubsequence(
                        "<CategoryNames>",
                        "<Category>unknown</Category>",
                        "<Category>too weak</Category>",
                        "<Category>detected</Category>");
    }

    private static BufferedImage readByTwelveMonkeys(Path file) throws IOException {
        List<ImageReader> readers = new ArrayList<>();
        for (Iterator<ImageReader> all = ImageIO.getImageReadersByFormatName("tiff"); all.hasNext(); ) {
            readers.add(all.next());
        }
        ImageReader reader = readers.stream()
                .filter(one -> one.getClass().getName().startsWith("com.twelvemonkeys"))
                .findFirst()
                .orElseThrow();
        try (ImageInputStream stream = ImageIO.createImageInputStream(file.toFile())) {
            reader.setInput(stream);
            return reader.read(0);
        } finally {
            reader.dispose();
        }
    }

    /** Equal grids give equal bytes, and a grid of a single cell is one, too. */
    @Test
    void theBytesDependOnTheCellsAlone() throws IOException {
        GeoTiff grid = new GeoTiff(origin(50, 15), 0, 0, 12.5, 2);
        grid.writeNumbers(directory.resolve("one.tif"), new float[] {1, 2, 3, Float.NaN});
        grid.writeNumbers(directory.resolve("two.tif"), new float[] {1, 2, 3, Float.NaN});
        assertThat(directory.resolve("two.tif")).hasSameBinaryContentAs(directory.resolve("one.tif"));
        new GeoTiff(origin(50, 15), 0, 0, 12.5, 1).writeCounts(directory.resolve("single.tif"), new int[] {3});
        assertThat(readByTwelveMonkeys(directory.resolve("single.tif"))
                        .getRaster()
                        .getSample(0, 0, 0))
                .isEqualTo(3);
    }
}
