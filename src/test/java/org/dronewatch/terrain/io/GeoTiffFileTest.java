package org.dronewatch.terrain.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files of every kind that is read, by a writer of the tests' own; then broken ones. */
class GeoTiffFileTest {
    private static final int COLUMNS = 37;
    private static final int ROWS = 29;

    @TempDir
    private Path directory;

    /** Slopes with something irregular on them; whole numbers where a file can hold no others. */
    private static TiffFixture fixture(int bits, int format) {
        double[] samples = new double[COLUMNS * ROWS];
        for (int i = 0; i < samples.length; i++) {
            double height = 100.0 + 1.37 * (i % COLUMNS) - 0.83 * (i / COLUMNS) + 11.0 * Math.sin(0.7 * i);
            samples[i] = format == 3 ? (float) height : Math.round(height);
        }
        TiffFixture fixture = new TiffFixture(COLUMNS, ROWS, samples);
        fixture.bits = bits;
        fixture.format = format;
        return fixture;
    }

    private static TiffFixture fixture() {
        return fixture(32, 3);
    }

    private ElevationFile open(byte[] bytes) throws IOException {
        Files.write(directory.resolve("dem.tif"), bytes);
        return new ElevationFiles(directory).open("dem.tif");
    }

    private ElevationFile open(TiffFixture fixture) throws IOException {
        return open(fixture.bytes());
    }

    private static float[] all(ElevationFile file) throws IOException {
        return file.heights(new Window(0, 0, file.columns(), file.rows()));
    }

    private static List<TiffFixture> variants() {
        List<TiffFixture> variants = new ArrayList<>();
        for (int[] sample : new int[][] {{32, 3}, {64, 3}, {16, 2}, {16, 1}, {8, 1}, {32, 2}}) {
            for (int compression : new int[] {1, 5, 8, 32946, 32773}) {
                for (int predictor : new int[] {1, 2, 3}) {
                    boolean fits = predictor == 1
                            || compression != 1
                                    && compression != 32773
                                    && (predictor == 3 ? sample[1] == 3 : sample[0] <= 32);
                    if (fits) {
                        for (int layout = 0; layout < 4; layout++) {
                            TiffFixture one = fixture(sample[0], sample[1]);
                            one.compression = compression;
                            one.predictor = predictor;
                            one.tile = layout % 2 == 0 ? 0 : 16;
                            one.big = layout == 3;
                            one.order = layout < 2 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
                            variants.add(one);
                        }
                    }
                }
            }
        }
        return variants;
    }

    @Test
    void everyVariantGivesItsHeightsExactly() throws IOException {
        List<TiffFixture> variants = variants();
        assertThat(variants).hasSize(204);
        for (TiffFixture one : variants) {
            String what = "bits " + one.bits + " format " + one.format + " compression " + one.compression
                    + " predictor " + one.predictor + " tile " + one.tile + " big " + one.big + " " + one.order;
            ElevationFile file = open(one);
            float[] heights = all(file);
            for (int i = 0; i < heights.length; i++) {
                assertThat(heights[i]).as(what + ", post " + i).isEqualTo((float) one.samples[i]);
            }
        }
    }

    @Test
    void aWindowIsAPartOfTheWhole() throws IOException {
        for (int tile : new int[] {0, 16}) {
            TiffFixture fixture = fixture();
            fixture.tile = tile;
            fixture.compression = 8;
            float[] part = open(fixture).heights(new Window(5, 11, 30, 13));
            for (int i = 0; i < part.length; i++) {
                assertThat(part[i]).isEqualTo((float) fixture.samples[(11 + i / 30) * COLUMNS + 5 + i % 30]);
            }
        }
    }

    /** A tile that a sparse file leaves out has no heights; all others have theirs. */
    @Test
    void aMissingTileIsAHole() throws IOException {
        TiffFixture fixture = fixture();
        fixture.tile = 16;
        fixture.compression = 8;
        fixture.missingBlock = 4;
        float[] heights = all(open(fixture));
        for (int i = 0; i < heights.length; i++) {
            boolean isMissing = i % COLUMNS >= 16 && i % COLUMNS < 32 && i / COLUMNS >= 16;
            assertThat(Float.isNaN(heights[i])).as("post %d", i).isEqualTo(isMissing);
        }
    }

    @ParameterizedTest
    @CsvSource({"-9999, -9999", "-32768, -32768", "-3.4028234663852886e+38, -3.4028234663852886e38", "nan, NaN", "0, 0"
    })
    void whatTheFileCallsNodataIsAHole(String tag, double value) throws IOException {
        TiffFixture fixture = fixture();
        fixture.samples[40] = value;
        fixture.nodata = tag;
        float[] heights = all(open(fixture));
        assertThat(heights[40]).isNaN();
        assertThat(heights[41]).isEqualTo((float) fixture.samples[41]);
    }

    /** Half a cell lies between the two. */
    @Test
    void pixelsAreAreasOrPoints() throws IOException {
        TiffFixture area = fixture();
        TiffFixture point = fixture();
        point.keys.put(1025, 2);
        assertThat(open(area).lattice()).isEqualTo(new Lattice(500_005, 4_999_995, 10, 0, 0, -10));
        assertThat(open(point).lattice()).isEqualTo(new Lattice(500_000, 5_000_000, 10, 0, 0, -10));
    }

    @Test
    void theTiePointMayBeAnyPixelAndAMatrixMayTurn() throws IOException {
        TiffFixture tied = fixture();
        tied.tie = new double[] {3, 4, 0, 500_030, 4_999_960, 0};
        assertThat(open(tied).lattice()).isEqualTo(new Lattice(500_005, 4_999_995, 10, 0, 0, -10));
        TiffFixture turned = fixture();
        turned.keys.put(1025, 2);
        turned.matrix = new double[] {6, 8, 0, 500_000, 8, -6, 0, 5_000_000, 0, 0, 0, 0, 0, 0, 0, 1};
        assertThat(open(turned).lattice()).isEqualTo(new Lattice(500_000, 5_000_000, 6, 8, 8, -6));
    }

    @Test
    void heightsMayBeStoredInFeetOrByAFactor() throws IOException {
        TiffFixture feet = fixture();
        feet.keys.put(4099, 9002);
        assertThat(all(open(feet))[9]).isEqualTo((float) (feet.samples[9] * 0.3048));
        // A vertical system in feet states them, too: NAVD88 in US survey feet, and in international ones.
        TiffFixture survey = fixture();
        survey.keys.put(4096, 6360);
        assertThat(all(open(survey))[9]).isEqualTo((float) (survey.samples[9] * (1200.0 / 3937.0)));
        survey.keys.put(4096, 8228);
        assertThat(all(open(survey))[9]).isEqualTo((float) (survey.samples[9] * 0.3048));
        // The unit takes precedence over that of the system.
        survey.keys.put(4099, 9001);
        assertThat(all(open(survey))[9]).isEqualTo((float) survey.samples[9]);
        TiffFixture decimetres = fixture(16, 2);
        decimetres.metadata = "<GDALMetadata>\n  <Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.1</Item>\n"
                + "  <Item name=\"OFFSET\" sample=\"0\" role=\"offset\">500</Item>\n</GDALMetadata>";
        assertThat(all(open(decimetres))[9]).isEqualTo((float) (500 + 0.1 * decimetres.samples[9]), within(1e-4F));
    }

    @Test
    void theSystemOfTheMapIsThatOfTheKeys() throws IOException {
        assertThat(open(fixture()).crs()).hasToString("Optional[EPSG:32633]");
        TiffFixture geographic = fixture();
        geographic.keys.remove(3072);
        geographic.keys.put(2048, 4326);
        assertThat(open(geographic).crs()).hasToString("Optional[EPSG:4326]");
        TiffFixture own = fixture();
        own.keys.put(3072, 32767);
        assertThat(open(own).crs()).isEmpty();
        TiffFixture compound = fixture();
        compound.keys.put(3072, 7415);
        assertThat(open(compound).crs()).hasToString("Optional[EPSG:7415]");
    }

    private void refused(Consumer<TiffFixture> change, String... parts) throws IOException {
        TiffFixture fixture = fixture();
        change.accept(fixture);
        byte[] bytes = fixture.bytes();
        assertThatThrownBy(() -> {
                    ElevationFile file = open(bytes);
                    file.crs();
                    all(file);
                })
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("dem.tif: ")
                .hasMessageContainingAll(parts)
                .hasMessageNotContaining("\n");
    }

    @ParameterizedTest
    @CsvSource({"50000, ZSTD", "34887, LERC", "34925, LZMA", "7, JPEG", "50001, WebP", "4711, unknown"})
    void otherCompressionsGetTheCommandThatConverts(int number, String name) throws IOException {
        refused(
                fixture -> fixture.lies.put(259, (long) number),
                name,
                "(" + number + ")",
                "gdal_translate -co COMPRESS=DEFLATE -co TILED=YES dem.tif");
    }

    @Test
    void whatIsNoElevationIsRefused() throws IOException {
        refused(fixture -> fixture.lies.put(277, 3L), "3 bands", "gdal_translate -b 1");
        refused(fixture -> fixture.lies.put(258, 12L), "12 bits");
        refused(fixture -> fixture.scale = new double[0], "no georeferencing");
        refused(fixture -> fixture.scale = new double[] {0, 10, 0}, "spans no area");
        refused(fixture -> fixture.scale = new double[] {Double.NaN, 10, 0}, "spans no area");
        refused(fixture -> fixture.keys.put(4099, 9036), "unit 9036");
        refused(fixture -> fixture.keys.put(3072, 9999), "EPSG:9999", "world.terrain.crs");
        refused(fixture -> fixture.nodata = "many", "nodata", "many");
    }

    /** Sizes that would fill the memory, tags that lie: each a line, before anything is taken. */
    @Test
    void hostileSizesAreRefusedBeforeMemoryIsTaken() throws IOException {
        refused(fixture -> fixture.lies.put(256, 1_000_000_000L), "1000000000 columns");
        refused(
                fixture -> {
                    fixture.lies.put(256, 16_000_000L);
                    fixture.lies.put(257, 16_000_000L);
                    fixture.lies.put(278, 16_000_000L);
                },
                "blocks of 16000000 x 16000000");
        refused(fixture -> fixture.lies.put(257, 10_000_000L), "blocks", "damaged");
        refused(fixture -> fixture.lies.put(258, 64L), "damaged");
        refused(fixture -> fixture.lies.put(278, 1L), "29 blocks");
        refused(
                fixture -> {
                    fixture.stripRows = ROWS;
                    fixture.lies.put(279, 0x7FFFFFFFL);
                },
                "2147483647 bytes");
        refused(
                fixture -> {
                    fixture.stripRows = ROWS;
                    fixture.lies.put(273, 0x7FFFFFF0L);
                },
                "beyond the file's");
    }

    /** A block of 4 KB that unpacks to 30 MB: only its samples are unpacked. */
    @Test
    void aBlockThatGoesOnUnpackingIsReadAsFarAsItsSamples() throws IOException {
        TiffFixture fixture = fixture();
        fixture.compression = 8;
        fixture.stripRows = ROWS;
        fixture.padding = 30_000_000;
        ElevationFile file = open(fixture);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        float[] heights = all(file);
        assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(10_000_000);
        for (int i = 0; i < heights.length; i++) {
            assertThat(heights[i]).isEqualTo((float) fixture.samples[i]);
        }
    }

    /** A file that is cut off anywhere; each length is tried. */
    @ParameterizedTest
    @ValueSource(ints = {1, 5, 8})
    void aFileThatIsCutOffIsRefused(int compression) throws IOException {
        TiffFixture fixture = fixture();
        fixture.compression = compression;
        byte[] bytes = fixture.bytes();
        for (int length = 1; length < bytes.length; length += 13) {
            byte[] some = java.util.Arrays.copyOf(bytes, length);
            assertThatThrownBy(() -> readAsTerrain(some))
                    .as("%d of %d bytes", length, bytes.length)
                    .isInstanceOf(InputException.class)
                    .hasMessageNotContaining("\n");
        }
    }

    /**
     * Bits turned over at random; the seed is 26. What still can be read may be wrong, but nothing else may be thrown.
     */
    @Test
    void turnedBitsNeverThrowAnythingElse() throws IOException {
        Random random = new Random(26);
        for (int i = 0; i < 600; i++) {
            TiffFixture fixture = fixture();
            fixture.compression = new int[] {1, 5, 8, 32773}[i % 4];
            fixture.predictor = i % 4 == 1 || i % 4 == 2 ? 3 : 1;
            fixture.tile = i % 3 == 0 ? 16 : 0;
            byte[] bytes = fixture.bytes();
            // Mostly in the header, where it hurts.
            int reach = i % 5 == 0 ? bytes.length : 500;
            for (int k = 0; k <= i % 4; k++) {
                bytes[random.nextInt(reach)] ^= (byte) (1 << random.nextInt(8));
            }
            try {
                readAsTerrain(bytes);
            } catch (InputException e) {
                assertThat(e.getMessage()).as("file %d", i).doesNotContain("\n");
            }
        }
    }

    /** As the loader reads: as many posts as it takes at most. */
    private void readAsTerrain(byte[] bytes) throws IOException {
        ElevationFile file = open(bytes);
        file.crs();
        try {
            file.heights(new Window(0, 0, Math.min(1000, file.columns()), Math.min(1000, file.rows())));
        } catch (IOException e) {
            throw ElevationFiles.unreadable("dem.tif", e);
        }
    }
}
