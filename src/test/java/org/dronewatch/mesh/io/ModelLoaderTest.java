package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ModelLoaderTest {
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\n";

    @TempDir
    private Path directory;

    private LoadedModel load(String text, ModelSettings settings) throws IOException {
        Files.writeString(directory.resolve("model.obj"), text);
        return new ModelLoader(directory).load(settings);
    }

    private LoadedModel load(String text) throws IOException {
        return load(text, ModelSettings.of("model.obj"));
    }

    @Test
    void aFileWithYUpIsTurnedSoThatZIsUpAndItsMinusZIsNorth() throws IOException {
        TriangleMesh mesh = load("v 1 2 -3\nv 0 0 0\nv 0 1 0\nf 1 2 3\n").mesh();

        assertThat(mesh.triangle(0).a()).isEqualTo(new Position(1, 3, 2));
    }

    @Test
    void aFormatThatNoReaderKnowsIsNamed() throws IOException {
        Files.writeString(directory.resolve("hangar.dae"), "solid hangar\nfacet normal 0 0 1\n");
        Files.writeString(directory.resolve("hangar.obj"), "solid hangar\nfacet normal 0 0 1\n");
        ModelLoader loader = new ModelLoader(directory);

        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> loader.load(ModelSettings.of("hangar.dae")))
                .withMessageContaining("hangar.dae:1: ")
                .withMessageEndingWith(
                        "; it was read as OBJ, because no reader for files of this name is on the class path");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> loader.load(ModelSettings.of("hangar.obj")))
                .withMessageNotContaining("class path");
    }

    @Test
    void scaleThenHeadingThenPositionPlaceAModel() throws IOException {
        ModelSettings settings = ModelSettings.of("model.obj")
                .withUpAxis(UpAxis.Z)
                .withScale(0.5)
                .withHeading(Math.PI / 2)
                .withPosition(new Position(10, 20, 30));

        // North (0, 2, 0) becomes 1 m long, turns clockwise to the east, and moves.
        Position placed = load("v 0 2 0\nv 0 0 0\nv 0 0 1\nf 1 2 3\n", settings)
                .mesh()
                .triangle(0)
                .a();

        assertThat(placed.distance(new Position(11, 20, 30))).isCloseTo(0.0, within(1e-6));
    }

    @Test
    void polygonsBecomeFansInTheOrderOfTheirCorners() throws IOException {
        TriangleMesh mesh = load(SQUARE + "v 0.5 0 -2\nf 1 2 3 5 4\n").mesh();

        assertThat(mesh.triangleCount()).isEqualTo(3);
        for (int i = 0; i < 3; i++) {
            assertThat(mesh.vertexIndex(i, 0)).isZero();
            assertThat(mesh.sourceNumber(i)).isEqualTo(i);
        }
        assertThat(mesh.vertexIndex(2, 1)).isEqualTo(4);
        assertThat(mesh.vertexIndex(2, 2)).isEqualTo(3);
    }

    @Test
    void trianglesWithoutAreaAreDroppedAndTheOthersKeepTheirNumbers() throws IOException {
        LoadedModel model = load(SQUARE + "f 1 2 2\nf 1 2 3\nf 1 1 1\nf 1 3 4\n");

        assertThat(model.dropped()).isEqualTo(2);
        assertThat(model.mesh().triangleCount()).isEqualTo(2);
        assertThat(model.mesh().sourceNumber(0)).isEqualTo(1);
        assertThat(model.mesh().sourceNumber(1)).isEqualTo(3);
    }

    @Test
    void relativeIndicesTabsCommentsContinuedLinesAndTextureIndicesAreRead() throws IOException {
        String text = "# a comment\n\nv\t0 0 0 # corner\nv 1 0 \\\n0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                + "s off\ng group\nl 1 2\nf -3/1/1 -2/1/1 -1/1/1 # a face\n";

        assertThat(load(text).mesh().triangleCount()).isEqualTo(1);
    }

    @Test
    void materialNamesAreKept() throws IOException {
        Files.writeString(directory.resolve("my.mtl"), "newmtl brick\nKd 1 0 0\nnewmtl glass\nKd 0 0 1\n");
        LoadedModel model =
                load("mtllib my.mtl\n" + SQUARE + "f 1 2 3\nusemtl glass\nf 1 3 4\nusemtl brick\nf 2 3 4\n");

        TriangleMesh mesh = model.mesh();
        assertThat(mesh.materialNames()).containsExactly("default", "glass", "brick");
        assertThat(mesh.materialNames().get(mesh.material(1))).isEqualTo("glass");
        assertThat(model.warnings()).isEmpty();
    }

    @Test
    void aMissingMaterialLibraryIsAWarning() throws IOException {
        LoadedModel model = load("mtllib absent.mtl\n" + SQUARE + "usemtl stone\nf 1 2 3\n");

        assertThat(model.warnings()).singleElement().asString().contains("absent.mtl");
        assertThat(model.mesh().materialNames()).containsExactly("stone");
    }

    @Test
    void aMaterialThatNoLibraryDefinesIsAWarning() throws IOException {
        Files.writeString(directory.resolve("my.mtl"), "newmtl brick\n");

        assertThat(load("mtllib my.mtl\n" + SQUARE + "usemtl brik\nf 1 2 3\n").warnings())
                .singleElement()
                .asString()
                .contains("brik");
    }

    @Test
    void aMaterialLibraryElsewhereIsNotRead() throws IOException {
        Path inside = Files.createDirectory(directory.resolve("inside"));
        Files.writeString(directory.resolve("secret.mtl"), "newmtl secret\n");
        Files.writeString(inside.resolve("model.obj"), "mtllib ../secret.mtl\n" + SQUARE + "usemtl secret\nf 1 2 3\n");

        assertThat(new ModelLoader(inside).load(ModelSettings.of("model.obj")).warnings())
                .singleElement()
                .asString()
                .contains("../secret.mtl");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "f 1 2 9           | model.obj:5: | 9",
                "f 1 2 -9          | model.obj:5: | -9",
                "f 1 2 0           | model.obj:5: | 0",
                "f 1 2             | model.obj:5: | 2 corners",
                "f 1 2 x           | model.obj:5: | x",
                "f 1 2 9999999999  | model.obj:5: | 9 digits",
                "f                 | model.obj:5: |",
                "v 1 NaN 0         | model.obj:5: | NaN",
                "v 1 Infinity 0    | model.obj:5: | Infinity",
                "v 1 1e39 0        | model.obj:5: | 1.0E39",
                "v 1 2             | model.obj:5: | 3",
                "v 1 2 three       | model.obj:5: | three",
                "v                 | model.obj:5: |",
            })
    void aBadLineIsNamed(String line, String place, String what) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(SQUARE + line + "\nf 1 2 3\n"))
                .satisfies(e -> assertThat(e.getMessage())
                        .contains(place)
                        .contains(what == null ? "" : what)
                        .doesNotContain("\n"));
    }

    @ParameterizedTest
    @CsvSource({
        "'',has no faces",
        "'v 0 0 0\n',has no faces",
        "'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n',has no area (1 triangle)"
    })
    void aFileWithoutAMeshIsRefused(String text, String what) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(text))
                .withMessageContaining("model.obj")
                .withMessageContaining(what);
    }

    @Test
    void aTruncatedFileIsRefusedWithTheLineWhereItEnds() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> load(SQUARE + "f 1 2 3\nf 1 2"))
                .withMessageContaining("model.obj:6:");
    }

    @Test
    void binaryDataIsRefused() throws IOException {
        byte[] bytes = new byte[4096];
        bytes[0] = 'v';
        Files.write(directory.resolve("model.obj"), bytes);

        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new ModelLoader(directory).load(ModelSettings.of("model.obj")))
                .withMessageContaining("model.obj");
    }

    @ParameterizedTest
    @CsvSource({"absent.obj", ".", "packaged:absent.obj", "packaged:../models/hill.obj", "packaged:"})
    void aMissingFileIsNamed(String file) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new ModelLoader(directory).load(ModelSettings.of(file)))
                .withMessageContaining(file.equals(".") ? directory.toString() : file.substring(file.indexOf(':') + 1));
    }
}
