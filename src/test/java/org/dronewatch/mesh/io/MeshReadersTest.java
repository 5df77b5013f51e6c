package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MeshReadersTest {
    @TempDir
    private Path directory;

    /** Gives a unit square for every file. */
    private record Square(Set<String> extensions) implements MeshReader {
        @Override
        public String summary() {
            return "squares";
        }

        @Override
        public LoadedModel read(ModelFile file, ModelSettings settings) {
            ModelCollector collector = new ModelCollector(file, settings);
            collector.addVertex(0, 0, 0);
            collector.addVertex(1, 0, 0);
            collector.addVertex(1, 1, 0);
            collector.addVertex(0, 1, 0);
            collector.addFace("grass", 0, 1, 2, 3);
            collector.addFace("line", 0, 1, 1);
            collector.setColour("grass", 0xFF00FF00);
            collector.warn("squares only");
            return collector.toModel();
        }
    }

    private ModelFile file(String name, String text) throws IOException {
        Files.writeString(directory.resolve(name), text);
        return ModelFile.find(directory, name);
    }

    @Test
    void theEndingOfANameChoosesTheReaderWhateverItsCase() {
        Square square = new Square(Set.of("sq", "square"));
        ObjReader obj = new ObjReader();
        MeshReaders readers = new MeshReaders(List.of(obj, square));
        assertThat(readers.of("a/b.sq")).isSameAs(square);
        assertThat(readers.of("B.SQUARE")).isSameAs(square);
        assertThat(readers.of("site.obj")).isSameAs(obj);
        assertThat(readers.of("site.sq.OBJ")).isSameAs(obj);
        assertThat(readers.of("site")).isSameAs(obj);
        assertThat(readers.byExtension().keySet()).containsExactly("obj", "sq", "square");
    }

    @Test
    void twoReadersOfOneEndingAreRefusedInOneLine() {
        List<MeshReader> twice = List.of(new Square(Set.of("sq")), new Square(Set.of("sq")));
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new MeshReaders(twice))
                .withMessageContaining("files '.sq' are read by ")
                .withMessageNotContaining("\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "OBJ", ".obj", "a b"})
    void anEndingThatNoNameCanHaveIsRefused(String extension) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new MeshReaders(List.of(new Square(Set.of(extension)))))
                .withMessageContaining("must be 1 to 16 lower-case letters and digits");
    }

    @Test
    void whatIsCollectedIsPlacedCutAndCounted() throws IOException {
        ModelSettings settings =
                ModelSettings.of("a.sq").withUpAxis(UpAxis.Z).withScale(2.0).withPosition(new Position(10, 20, 30));
        LoadedModel model = new Square(Set.of("sq")).read(file("a.sq", "x"), settings);
        assertThat(model.mesh().triangleCount()).isEqualTo(2);
        assertThat(model.dropped()).isEqualTo(1);
        assertThat(model.mesh().bounds().minX()).isEqualTo(10.0f);
        assertThat(model.mesh().bounds().maxY()).isEqualTo(22.0f);
        assertThat(model.mesh().bounds().maxZ()).isEqualTo(30.0f);
        assertThat(model.colours()).containsEntry("grass", 0x00FF00);
        assertThat(model.warnings()).containsExactly("squares only");
        assertThat(model.files()).hasSize(1);
    }

    @Test
    void theCollectorGivesTheMeshThatTheObjReaderGives() throws IOException {
        ModelFile file = file("a.obj", "v 0 0 0\nv 3 0 0\nv 3 0 4\nv 1 2 1\nusemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\n");
        ModelSettings settings = ModelSettings.of("a.obj").withHeading(0.7).withPosition(new Position(1, 2, 3));
        ModelCollector collector = new ModelCollector(file, settings);
        collector.addVertex(0, 0, 0);
        collector.addVertex(3, 0, 0);
        collector.addVertex(3, 0, 4);
        collector.addVertex(1, 2, 1);
        collector.addFace("a", 0, 1, 2);
        collector.addFace("b", 1, 2, 3);
        assertThat(collector.toModel().mesh())
                .usingRecursiveComparison()
                .isEqualTo(new ObjReader().read(file, settings).mesh());
    }

    @Test
    void whatCannotBeAMeshIsRefusedWithTheFilesName() throws IOException {
        ModelCollector far = new ModelCollector(file("a.sq", "x"), ModelSettings.of("a.sq"));
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> far.addVertex(Float.NaN, 0, 0))
                .withMessageContaining("a.sq: vertex 0 (NaN");
        ModelCollector collector = new ModelCollector(file("a.sq", "x"), ModelSettings.of("a.sq"));
        collector.addVertex(0, 0, 0);
        collector.addVertex(0, 1, 0);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> collector.addFace("m", 0, 1))
                .withMessageContaining("face 0 has 2 corners");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> collector.addFace("m", 0, 1, 7))
                .withMessageContaining("face 0: vertex index 7 must be 0 to 1");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(collector::toModel)
                .withMessageContaining("not a mesh");
    }
}
