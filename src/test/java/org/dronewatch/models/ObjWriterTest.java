package org.dronewatch.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ObjWriterTest {

    @ParameterizedTest
    @CsvSource({
        "1.25, 3, 1.250",
        "-1.25, 3, -1.250",
        "-0.0001, 3, 0.000",
        "-0.0, 2, 0.00",
        "0.0005, 3, 0.001",
        "1234567.891, 1, 1234567.9",
        "-0.05, 1, 0.0",
        "7, 0, 7"
    })
    void numbersHaveFixedDecimalsAndNoNegativeZero(double value, int decimals, String expected) {
        StringBuilder text = new StringBuilder();
        ObjWriter.appendFixed(text, value, decimals);

        assertThat(text).hasToString(expected);
    }

    @Test
    void aTriangleIsWrittenInFull() {
        Material red = new Material("red", 1, 0, 0);
        Solid.Facet facet =
                new Solid.Facet(red, java.util.List.of(new Point(0, 0, 0), new Point(1, 0, 0), new Point(0, 1.5, -2)));
        Mesh mesh = new MeshBuilder("tri", 1)
                .addFacets("part", java.util.List.of(facet))
                .build();

        assertThat(ObjWriter.obj(mesh).lines().skip(1))
                .containsExactly(
                        "mtllib tri.mtl",
                        "v 0.0 0.0 0.0",
                        "v 1.0 0.0 0.0",
                        "v 0.0 1.5 -2.0",
                        "o part",
                        "usemtl red",
                        "f 1 2 3");
        assertThat(ObjWriter.mtl(mesh))
                .contains("newmtl red\nKd 1.000 0.000 0.000\n")
                .doesNotContain("\r");
    }

    @Test
    void namesThatAFileCannotCarryAreRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Material("two words", 0, 0, 0));
    }
}
