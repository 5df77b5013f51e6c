package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.List;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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
    void everyCoordinateIsWhereTheArraysHaveIt() {
        float[] vertices = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        int[] corners = {3, 0, 2, 1, 2, 3};
        TriangleMesh mesh = TriangleMesh.of(vertices, corners);

        for (int axis = 0; axis < 3; axis++) {
            for (int vertex = 0; vertex < 4; vertex++) {
                assertThat(mesh.vertexCoordinate(vertex, axis)).isEqualTo(3 * vertex + axis + 1);
            }
            for (int i = 0; i < corners.length; i++) {
                assertThat(mesh.coordinate(i / 3, i % 3, axis)).isEqualTo(3 * corners[i] + axis + 1);
                assertThat(mesh.vertexIndex(i / 3, i % 3)).isEqualTo(corners[i]);
            }
        }
    }

    @Test
    void givesCopiesOfItsArrays() {
        int[] corners = {0, 1, 2, 2, 1, 0};
        TriangleMesh mesh =
                new TriangleMesh(VERTICES, corners, new int[] {1, 0}, new int[] {5, 7}, List.of("grass", "rock"));
        mesh.vertices()[0] = 99;
        mesh.corners()[0] = 99;
        mesh.materials()[0] = 99;
        mesh.sourceNumbers()[0] = 99;

        assertThat(mesh.vertices()).containsExactly(VERTICES);
        assertThat(mesh.corners()).containsExactly(corners);
        assertThat(mesh.materials()).containsExactly(1, 0);
        assertThat(mesh.sourceNumbers()).containsExactly(5, 7);
    }

    @Test
    void theRadiusIsThatOfTheFarthestCornerInUse() {
        float[] vertices = {1, 0, 0, -2, 3, -6, 0, 1, 0, 9, 9, 9};

        assertThat(TriangleMesh.of(vertices, new int[] {0, 1, 2}).radius()).isEqualTo(7.0);
        assertThat(TriangleMesh.of(vertices, new int[] {1, 2, 0}).radius()).isEqualTo(7.0);
        assertThat(TriangleMesh.of(vertices, new int[] {0, 0, 2, 2, 0, 1}).radius())
                .isEqualTo(7.0);
        assertThat(TriangleMesh.of(vertices, new int[0]).radius()).isZero();
    }

    @Test
    void theRadiusOfALargeMeshDoesNotOverflow() {
        float[] vertices = {0, 0, 0, 0, 0, TriangleMesh.MAX_COORDINATE, 0, 1, 0};

        assertThat(TriangleMesh.of(vertices, new int[] {0, 1, 2}).radius()).isEqualTo(TriangleMesh.MAX_COORDINATE);
    }

    /** The least and the greatest coordinate are at each of the corners in turn. */
    @ParameterizedTest
    @CsvSource({"0, 1, 2", "1, 2, 0", "2, 0, 1", "0, 2, 1", "2, 1, 0", "1, 0, 2"})
    void theLeastAndTheGreatestCoordinateMayBeAtAnyCorner(int first, int second, int third) {
        float[] vertices = {-5, 40, 3, 1, 20, -0.25f, 2, -60, 7};
        TriangleMesh mesh = TriangleMesh.of(vertices, new int[] {0, 0, 0, first, second, third});

        assertThat(new float[] {mesh.least(1, 0), mesh.least(1, 1), mesh.least(1, 2)})
                .containsExactly(-5, -60, -0.25f);
        assertThat(new float[] {mesh.greatest(1, 0), mesh.greatest(1, 1), mesh.greatest(1, 2)})
                .containsExactly(2, 40, 7);
    }

    /** With the edges (2, 5, 3) and (4, 2, 7) from the first corner. */
    @Test
    void theNormalIsTheCrossProductOfTwoEdges() {
        float[] vertices = {0, 0, 0, 1, 2, 4, 3, 7, 7, 5, 4, 11};
        TriangleMesh mesh = TriangleMesh.of(vertices, new int[] {0, 0, 0, 1, 2, 3, 1, 3, 2});
        double[] normal = new double[3];

        mesh.normal(1, normal);
        assertThat(normal).containsExactly(29, -2, -16);
        mesh.normal(2, normal);
        assertThat(normal).containsExactly(-29, 2, 16);
        mesh.normal(0, normal);
        assertThat(normal).containsExactly(0, 0, 0);
        assertThat(mesh.triangle(1).areaNormal()).isEqualTo(new Vector3d(29, -2, -16));
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
                .withMessageContaining("vertex 3 has the coordinate " + bad);
    }

    @Test
    void takesCoordinatesAtTheLimit() {
        float[] vertices = VERTICES.clone();
        vertices[3] = TriangleMesh.MAX_COORDINATE;

        assertThat(TriangleMesh.of(vertices, new int[] {0, 1, 2}).bounds().maxX())
                .isEqualTo(TriangleMesh.MAX_COORDINATE);
    }
}
