package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import org.dronewatch.geometry.AABB;
import org.dronewatch.mesh.polygon.PolygonCutterTest;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Which statements of the OBJ format are read, skipped and refused. */
class ObjStatementsTest {
    private static final Path FORMER_FAILURES = Path.of("src/test/resources/fuzz");
    private static final int LONG_LINES = 16;
    private static final String MARK = "\uFEFF";
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    @TempDir
    private Path directory;

    private LoadedModel load(String text) throws IOException {
        Files.writeString(directory.resolve("model.obj"), text);
        return new ModelLoader(directory).load(ModelSettings.of("model.obj"));
    }

    private static LoadedModel former(String name) {
        return new ModelLoader(FORMER_FAILURES).load(ModelSettings.of(name + "/model.obj"));
    }

    @Test
    void aByteOrderMarkDoesNotHideTheFirstVertex() {
        AABB bounds = former("byte-order-mark-before-a-vertex").mesh().bounds();

        assertThat(bounds.maxX() - bounds.minX()).isEqualTo(10.0);
        // The model has y up where the world has z up.
        assertThat(bounds.maxY() - bounds.minY()).isZero();
        assertThat(bounds.maxZ() - bounds.minZ()).isEqualTo(10.0);
    }

    @Test
    void aByteOrderMarkDoesNotHideTheFirstMaterial() throws IOException {
        Files.writeString(directory.resolve("my.mtl"), MARK + "newmtl brick\nKd 1 0 0\n");

        LoadedModel model = load(MARK + "mtllib my.mtl\n" + TRIANGLE + "usemtl brick\nf 1 2 3\n");

        assertThat(model.colours()).containsExactly(Map.entry("brick", 0xff0000));
        assertThat(model.warnings()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", MARK, "\r\n", "v"})
    void aFileOfAFewBytesHasNoFaces(String text) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(text))
                .withMessageContaining("model.obj");
    }

    @Test
    void aWordThatTheFormatDoesNotHaveIsNamedWithItsLine() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> former("unknown-word-before-a-vertex"))
                .withMessageContaining("model.obj:1: unknown keyword 'w'");
    }

    @ParameterizedTest
    @CsvSource({"vv 1 2 3", "V1 2 3", "vertex 1 2 3", "1 2 3", "f1 2 3", "<html>", "{", MARK + "v 1 2 3", "/", "\\ 1"})
    void aMistypedWordIsNotSkipped(String line) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(TRIANGLE + line + "\nf 1 2 3\n"))
                .withMessageContaining("model.obj:4: unknown keyword '" + line.split(" ")[0].replace(MARK, "\\ufeff"));
    }

    @Test
    void aLongUnknownWordIsShortenedInTheMessage() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load("x".repeat(100_000) + "\n" + TRIANGLE + "f 1 2 3\n"))
                .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(500).contains("model.obj:1:"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "vt",
                "vn",
                "vp",
                "cstype",
                "deg",
                "bmat",
                "step",
                "p",
                "l",
                "curv",
                "curv2",
                "surf",
                "parm",
                "trim",
                "hole",
                "scrv",
                "sp",
                "end",
                "con",
                "g",
                "s",
                "mg",
                "o",
                "bevel",
                "c_interp",
                "d_interp",
                "lod",
                "usemap",
                "maplib",
                "shadow_obj",
                "trace_obj",
                "ctech",
                "stech",
                "bsp",
                "bzp",
                "cdc",
                "cdp",
                "res",
                "call",
                "csh"
            })
    void wordsOfTheFormatWithoutEffectAreSkippedAndCounted(String word) throws IOException {
        LoadedModel model =
                load(word + " 1 2 x\n" + TRIANGLE + word.toUpperCase(java.util.Locale.ROOT) + "\nf 1 2 3\n");

        assertThat(model.skipped()).containsExactly(Map.entry(word, 2));
        assertThat(model.describe()).endsWith("; skipped 2 '" + word + "' statements");
        assertThat(model.mesh().triangleCount()).isEqualTo(1);
    }

    @Test
    void skippedStatementsThatWouldAddSurfacesAreAWarning() {
        LoadedModel model = former("words-without-effect");

        assertThat(model.warnings()).singleElement().asString().contains("missing: 1 call, 1 surf");
        assertThat(model.describe()).endsWith("; skipped 1 'call', 1 'o', 1 's', 1 'surf', 1 'vp', 1 'vt' statements");
    }

    @Test
    void theDescriptionOfAFileWithoutSuchStatementsDoesNotMentionThem() throws IOException {
        assertThat(load(TRIANGLE + "f 1 2 3\n").describe())
                .contains(": 1 triangle, ")
                .endsWith("1 material");
        assertThat(load(TRIANGLE + "f 1 2 3\nf 1 2 2\n").describe())
                .contains(": 1 triangle (1 of zero area dropped), ");
    }

    @Test
    void aBackslashAtTheEndOfACommentContinuesNothing() throws IOException {
        assertThat(former("backslash-at-the-end-of-a-comment").mesh().vertexCount())
                .isEqualTo(4);
        assertThat(load("v 0 0 0 # C:\\\nv 1 0 \\\n0 # D:\\\nv 0 1 0\nf 1 2 3 # E:\\")
                        .mesh()
                        .vertexCount())
                .isEqualTo(3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void linesEndAsOnAnySystem(String end) throws IOException {
        String text = (TRIANGLE + "f 1 \\\n2 3\nw").replace("\n", end);

        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(text))
                .withMessageContaining("model.obj:6: unknown keyword 'w'");
        assertThat(load(text.substring(0, text.length() - 1)).mesh().triangleCount())
                .isEqualTo(1);
    }

    @Test
    void theOutlineOfAFaceIsAFaceAndWordsMayBeCapitals() throws IOException {
        LoadedModel model = load("V 0 0 0\nV 1 0 0\nV 0 1 0 0.5 0.5 0.5\nUseMtl a\nFO 1 2 3\nF 1/ 2// 3//4\n");

        assertThat(model.mesh().triangleCount()).isEqualTo(2);
        assertThat(model.mesh().materialNames()).containsExactly("a");
    }

    @ParameterizedTest
    @CsvSource({
        "f 1 2 3/x, 3/x",
        "f 1 2 3/1/1/1, 3/1/1/1",
        "f 1 2 /3, /3",
        "f 1 2 -, -",
        "f 1 2 3.0, 3.0",
        "f 1 2 +3, +3",
        "f 1 2 --3, --3",
        "f 1 2 \u0663, \u0663",
        "f 1 / 2 3, /",
        "v 1 2 3 x, x",
        "v 1 2 3 4 5 6 blue, blue",
        "v 1 2, 2 coordinates",
        "v, 0 coordinates",
        "f, 0 corners",
        "f 1 2 0, index 0",
        "f 1 2 -4, -4 lies before"
    })
    void aNumberThatCannotBeReadIsNamed(String line, String what) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(TRIANGLE + line + "\nf 1 2 3\n"))
                .withMessageContaining("model.obj:4: ")
                .withMessageContaining(what);
    }

    @Test
    void aFaceMayComeBeforeItsVerticesWhateverItsShape() throws IOException {
        LoadedModel model = load("f 1 2 3 4\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\n");

        assertThat(PolygonCutterTest.area(model.mesh())).isEqualTo(4.0);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(TRIANGLE + "f 1 2 3\n\nf 1 2 3 7\nf 1 2 3\n"))
                .withMessageContaining("model.obj:6: vertex index 7 lies beyond the last vertex (3 vertices)");
    }

    @ParameterizedTest
    @ValueSource(strings = {" ", " \\\n"})
    void aFaceLineOfAlmostAMebibyteIsReadInLinearTime(String separator) throws IOException {
        String corners = ("1" + separator).repeat(ObjLines.LONGEST_LINE / (separator.length() + 2) - 10);

        // Copying what was read with each piece would take many minutes for this many lines.
        String lines = ("f " + corners + "2 3\n").repeat(LONG_LINES);
        LoadedModel model = assertTimeoutPreemptively(Duration.ofMinutes(1), () -> load(TRIANGLE + lines));

        assertThat(model.mesh().triangleCount()).isEqualTo(LONG_LINES);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() ->
                        assertTimeoutPreemptively(Duration.ofMinutes(1), () -> load(TRIANGLE + "f " + corners + "x\n")))
                .withMessageContaining("model.obj:4: not a corner of a face: 'x'");
    }

    @Test
    void aLineBeyondTheLimitIsRefusedBeforeAllOfItIsRead() throws IOException {
        Path file = directory.resolve("model.obj");
        Files.writeString(file, TRIANGLE + "f 1 2 3\n");
        byte[] block = " 1".repeat(1 << 19).getBytes(java.nio.charset.StandardCharsets.US_ASCII);
        for (int i = 0; i < 50; i++) {
            Files.write(file, block, java.nio.file.StandardOpenOption.APPEND);
        }

        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new ModelLoader(directory).load(ModelSettings.of("model.obj")))
                .withMessageContaining("model.obj:5: line of more than 1048576 characters");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "Kd",
                "Kd x y z",
                "Kd spectral a.rfl",
                "Ns",
                "map_Kd",
                "\\",
                "d -halo",
                "Pr 0.5 \\",
                "Kd 1 0 0\n\\\n\\",
                "norm -bm",
                "illum",
                "newmtl",
                "map_Kd -o"
            })
    void oddStatementsOfAMaterialLibraryAreNeverMoreThanWarnings(String statement) throws IOException {
        for (String text : new String[] {statement, "newmtl a\n" + statement, "newmtl a\nunknown 1 2\n" + statement}) {
            Files.writeString(directory.resolve("my.mtl"), text);

            LoadedModel model = load("mtllib my.mtl\n" + TRIANGLE + "usemtl a\nf 1 2 3\n");

            assertThat(model.mesh().triangleCount()).isEqualTo(1);
        }
    }

    @Test
    void extensionsInAMaterialLibraryDoNotHideColours() throws IOException {
        Files.writeString(
                directory.resolve("my.mtl"),
                "# PBR\nnewmtl a\nPr 0.4\nPm 0.1\nPs 0\nPc 0\nPcr 0\naniso 0\nanisor 0\nKe 0 0 0\nnorm n.png\nmap_Pr r.png\n"
                        + "vendor thing\nKd 0 1 0\n");

        LoadedModel model = load("mtllib my.mtl\n" + TRIANGLE + "usemtl a\nf 1 2 3\n");

        assertThat(model.warnings()).isEmpty();
        assertThat(model.colours()).containsExactly(Map.entry("a", 0x00ff00));
    }

    @Test
    void thousandsOfUndefinedMaterialsAreAShortWarning() throws IOException {
        Files.writeString(directory.resolve("my.mtl"), "newmtl other\n");
        StringBuilder text = new StringBuilder("mtllib my.mtl\n" + TRIANGLE);
        for (int i = 0; i < 20_000; i++) {
            text.append("mtllib my.mtl\nusemtl m").append(i).append("\nf 1 2 3\n");
        }

        assertThat(load(text.toString()).warnings())
                .singleElement()
                .asString()
                .endsWith("and 19990 more")
                .hasSizeLessThan(500);
    }
}
