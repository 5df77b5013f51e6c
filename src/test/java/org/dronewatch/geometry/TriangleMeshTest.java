package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.List;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TriangleMeshTest {
    private static final float[] VERTICES = {0, 0, 0, 3, 0, 0, 0, 4, 0, 9, 9, 9};

    @Test
    void namesItsTrianglesByTheirCorners() {
        TriangleMesh mesh = new TriangleMesh(
                VERTICES, new int[] {0, 1, 2, 2, 1, 0}, new int[] {1, 0}, new int[] {5, 7}, List.of("grass", "rock"));

        assertThat(mesh.triangleCount()).isEqualTo(2);
        assertThat(mesh.vertexCount()).isEqualTo(4);
        assertThat(mesh.coordinate(1, 0, 1)).isEqualTo(4f);
        assertThat(mesh.vertexCoordinate(1, 0)).isEqualTo(3f);
        assertThat(mesh.vertexIndex(1, 0)).isEqualTo(2);
        assertThat(mesh.material(0)).isEqualTo(1);
        assertThat(mesh.materialNames()).containsExactly("grass", "rock");
        assertThat(mesh.sourceNumber(1)).isEqualTo(7);
        assertThat(mesh.triangle(0))
                .isEqualTo(new Triangle(new Position(0, 0, 0), new Position(3, 0, 0), new Position(0, 4, 0), 0, 1));
    }

    @Test
    void aTriangleHasAnAreaANormalAndABox() {
        Triangle triangle = TriangleMesh.of(VERTICES, new int[] {0, 1, 2}).triangle(0);

        assertThat(triangle.area()).isEqualTo(6.0);
        assertThat(triangle.areaNormal()).isEqualTo(new Vector3d(0, 0, 12));
        assertThat(triangle.bounds()).isEqualTo(new AABB(0, 0, 0, 3, 4, 0));
    }

    @Test
    void boundsLeaveOutUnusedVertices() {
        assertThat(TriangleMesh.of(VERTICES, new int[] {0, 1, 2}).bounds()).isEqualTo(new AABB(0, 0, 0, 3, 4, 0));
    }

    @Test
    void nothingHasNoBounds() {
        TriangleMesh nothing = TriangleMesh.of(VERTICES, new int[0]);

        assertThat(nothing.triangleCount()).isZero();
        assertThatIllegalStateException().isThrownBy(nothing::bounds);
    }

    @Test
    void cannotBeChangedThroughTheArraysItWasMadeFrom() {
        float[] vertices = VERTICES.clone();
        int[] corners = {0, 1, 2};
        TriangleMesh mesh = TriangleMesh.of(vertices, corners);
        vertices[3] = 99;
        corners[0] = 1;

        assertThat(mesh.bounds()).isEqualTo(new AABB(0, 0, 0, 3, 4, 0));
        assertThat(mesh.vertexIndex(0, 0)).isZero();
    }

    @Test
    void refusesArraysThatDoNotFit() {
        assertThatIllegalArgumentException().isThrownBy(() -> TriangleMesh.of(new float[4], new int[0]));
        assertThatIllegalArgumentException().isThrownBy(() -> TriangleMesh.of(VERTICES, new int[] {0, 1}));
        assertThatIllegalArgumentException()
                .isThrownBy(() ->
                        new TriangleMesh(VERTICES, new int[] {0, 1, 2}, new int[2], new int[1], List.of("default")));
        assertThatIllegalArgumentException()
                .isThrownBy(() ->
                        new TriangleMesh(VERTICES, new int[] {0, 1, 2}, new int[1], new int[2], List.of("default")));
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 4})
    void refusesCornersThatAreNoVertices(int corner) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TriangleMesh.of(VERTICES, new int[] {0, 1, corner}))
                .withMessageContaining("corner index " + corner + " at entry 2");
    }

    @Test
    void refusesMaterialsWithoutName() {
        assertThatIllegalArgumentException()
                .isThrownBy(() ->
                        new TriangleMesh(VERTICES, new int[] {0, 1, 2}, new int[] {1}, new int[1], List.of("default")))
                .withMessageContaining("material index 1");
    }

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, 1.1e30f, -1.1e30f})
    void refusesCoordinatesBeyondTheLimit(float bad) {
        float[] vertices = VERTICES.clone();
        vertices[10] = bad;

        assertThatIllegalArgumentException()
                .isThrownBy(() -> TriangleMesh.of(vertices, new int[] {0, 1, 2}))
                .withMessageContaining("vertex 3");
    }

    @Test
    void takesCoordinatesAtTheLimit() {
        float[] vertices = VERTICES.clone();
        vertices[3] = TriangleMesh.MAX_COORDINATE;

        assertThat(TriangleMesh.of(vertices, new int[] {0, 1, 2}).bounds().maxX())
                .isEqualTo(TriangleMesh.MAX_COORDINATE);
    }
}
