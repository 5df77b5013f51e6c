package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronewatch.Thorough;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TreeStructureTest {

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"hill.obj", "quadrotor.obj"})
    void treesOfModelsAreSound(String model) {
        TreeValidator.validate(model, KDTree.of(Meshes.model(model)));
    }

    @Test
    void treesOfClosedMeshesAreSound() {
        TreeValidator.validate("room", KDTree.of(Meshes.room()));
        TreeValidator.validate("ball", KDTree.of(Meshes.icosphere(5)));
    }

    @Test
    void treesOfRandomTrianglesAreSound() {
        for (int seed = 0; seed < 40; seed++) {
            int triangles = 1 << seed % 10;
            double share = 0.02 + 0.12 * (seed % 8);
            TreeValidator.validate("soup " + seed, KDTree.of(Meshes.soup(triangles, share, seed)));
        }
    }

    @Test
    void treesOfDegenerateMeshesAreSound() {
        Meshes.degenerate().forEach((name, mesh) -> TreeValidator.validate(name, KDTree.of(mesh)));
    }

    @Test
    void noTrianglesMakeOneEmptyLeaf() {
        KDTreeStats stats = KDTreeStats.of(KDTree.of(TriangleMesh.of(new float[0], new int[0])));

        assertThat(stats).isEqualTo(new KDTreeStats(0, 1, 1, 1, 0.0, 0, 0, 0.0, 8));
    }

    @Test
    void trianglesThatNoPlanePartsShareALeaf() {
        KDTree tree = KDTree.of(Meshes.degenerate().get("identical"));

        assertThat(KDTreeStats.of(tree).maxLeafSize()).isEqualTo(50);
    }

    @Test
    void theRootsBoxIsTheMeshsBoundsRoundedOutwards() {
        TriangleMesh mesh = Meshes.soup(100, 0.2, 12);
        double slack = 4 * Math.ulp(1f);

        assertThat(KDTree.of(mesh).bounds().union(mesh.bounds()))
                .isEqualTo(KDTree.of(mesh).bounds());
        assertThat(KDTree.of(mesh).bounds().maxX() - mesh.bounds().maxX()).isBetween(0.0, slack);
        assertThat(mesh.bounds().minZ() - KDTree.of(mesh).bounds().minZ()).isBetween(0.0, slack);
    }

    @Test
    void theSameMeshGivesTheSameTree() {
        KDTree first = KDTree.of(Meshes.soup(2000, 0.1, 13));
        KDTree second = KDTree.of(Meshes.soup(2000, 0.1, 13));

        assertThat(second.nodes()).isEqualTo(first.nodes());
        assertThat(second.leafTriangles()).isEqualTo(first.leafTriangles());
        assertThat(second.triangles().numbers()).isEqualTo(first.triangles().numbers());
        assertThat(second.rootBox()).isEqualTo(first.rootBox());
    }

    @Test
    void theDepthLimitIsEightAndOnePointThreeTimesTheLogarithm() {
        assertThat(KDTreeBuilder.depthLimit(0)).isEqualTo(8);
        assertThat(KDTreeBuilder.depthLimit(1)).isEqualTo(8);
        assertThat(KDTreeBuilder.depthLimit(1024)).isEqualTo(21);
        assertThat(KDTreeBuilder.depthLimit(65536)).isEqualTo(28);
    }
}
