package org.dronewatch.terrain.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AsciiGridFileTest {
    private static final String HEADER = "ncols 3\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n";

    @TempDir
    private Path directory;

    private ElevationFile open(String text) throws IOException {
        Files.writeString(directory.resolve("dem.asc"), text);
        return new ElevationFiles(directory).open("dem.asc");
    }

    private static float[] all(ElevationFile file) throws IOException {
        return file.heights(new Window(0, 0, file.columns(), file.rows()));
    }

    @Test
    void theFirstRowIsTheNorthernmost() throws IOException {
        ElevationFile file = open(HEADER + "NODATA_value -1\n1.5 2 3\n4 -1 6e1\n");
        assertThat(all(file)).containsExactly(1.5F, 2, 3, 4, Float.NaN, 60);
        assertThat(file.lattice()).isEqualTo(new Lattice(1005, 2015, 10, 0, 0, -10));
        assertThat(file.heights(new Window(1, 1, 2, 1))).containsExactly(Float.NaN, 60);
        assertThat(file.crs()).isEmpty();
    }

    @Test
    void centresAndSeparateStepsAreUnderstood() throws IOException {
        ElevationFile file =
                open("NROWS 2\r\nNCOLS 3\r\nXLLCENTER 1000\r\nYLLCENTER 2000\r\ndx 10\r\ndy 20\r\n1 2 3 4 5 6");
        assertThat(file.lattice()).isEqualTo(new Lattice(1000, 2020, 10, 0, 0, -20));
    }

    /** Without a line that says so -9999 is no height, as in Esri's programs; 0 is one. */
    @Test
    void withoutNodataItIsTheUsualOne() throws IOException {
        assertThat(all(open(HEADER + "0 -9999 3 4 -9.999e+03 6"))).containsExactly(0, Float.NaN, 3, 4, Float.NaN, 6);
    }

    /** GDAL writes them in lower case, others as Java does. */
    @Test
    void nodataMayBeNotANumber() throws IOException {
        assertThat(all(open(HEADER + "NODATA_value nan\n0 nan 3\n4 NaN -9999")))
                .containsExactly(0, Float.NaN, 3, 4, Float.NaN, -9999);
    }

    @ParameterizedTest
    @CsvSource({
        "1 2 3 4 5, ends after 5 of 6 heights",
        "1 2 3 4 5 6 7, dem.asc:6: has more heights than the 6",
        "1 2 x 4 5 6, dem.asc:6: 'x' must be a number",
    })
    void heightsMustBeThere(String heights, String message) {
        assertThatThrownBy(() -> all(open(HEADER + heights)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message);
    }

    /** The file must be as long as its posts need before memory is taken for them. */
    @Test
    void aHeaderThatLiesIsRefused() {
        String lies = HEADER.replace("ncols 3", "ncols 300000").replace("nrows 2", "nrows 200000");
        assertThatThrownBy(() -> open(lies + "1 2 3"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("300000 x 200000 posts, but has only 73 bytes");
    }

    @ParameterizedTest
    @CsvSource({
        "ncols 3, ncols -3, ncols -3.0 must be a whole number of 2 or more",
        "ncols 3, ncols 1e99, ncols 1.0E99 must be a whole number",
        "ncols 3, ncols 3 ncols 3, dem.asc:1: 'ncols' is given twice",
        "cellsize 10, cellsize 0, cellsize 0.0 must be above 0",
        "cellsize 10, cellsize NaN, cellsize NaN must be above 0",
        "cellsize 10, '', its header needs 'cellsize'",
        "xllcorner 1000, '', its header needs 'xllcorner'",
        "xllcorner 1000, xllcorner Infinity, xllcorner Infinity must be finite",
    })
    void theHeaderMustBeWhole(String from, String to, String message) {
        assertThatThrownBy(() -> all(open(HEADER.replace(from, to) + "1 2 3 4 5 6")))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("dem.asc")
                .hasMessageContaining(message);
    }

    @Test
    void wordsAreBounded() {
        assertThatThrownBy(() -> all(open(HEADER + "1 2 " + "9".repeat(1000) + " 4 5 6")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("dem.asc:6")
                .hasMessageContaining("a number of more than 64 characters");
    }

    @Test
    void otherFilesAreNamed() throws IOException {
        assertThatThrownBy(() -> open("{\"type\": \"FeatureCollection\"}"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("is a JSON file, which belongs under world.buildings, not under world.terrain");
        assertThatThrownBy(() -> open("x y z 1 2 3"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "is not a GeoTIFF file, an SRTM tile (.hgt, also in .zip or .gz) or an ESRI ASCII grid")
                .hasMessageContaining("gdal_translate dem.asc dem.tif");
        assertThatThrownBy(() -> open("")).isInstanceOf(InputException.class).hasMessage("dem.asc: is empty");
    }
}
