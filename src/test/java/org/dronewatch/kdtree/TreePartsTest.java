package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** A tree is made of its stored parts, if they are parts of a tree. */
class TreePartsTest {
    private static final KDTree TREE = KDTree.of(mesh(300, new SplittableRandom(5)));

    /** Triangles all over a box, some of them large. */
    static TriangleMesh mesh(int count, SplittableRandom random) {
        float[] vertices = new float[9 * count];
        int[] corners = new int[3 * count];
        for (int i = 0; i < count; i++) {
            double size = i % 10 == 0 ? 20.0 : 2.0;
            for (int axis = 0; axis < 3; axis++) {
                double at = 50.0 * random.nextDouble() - 25.0;
                for (int corner = 0; corner < 3; corner++) {
                    vertices[9 * i + 3 * corner + axis] = (float) (at + size * random.nextDouble());
                }
            }
            for (int corner = 0; corner < 3; corner++) {
                corners[3 * i + corner] = 3 * i + corner;
            }
        }
        return TriangleMesh.of(vertices, corners);
    }

    private static TreeParts changed(Consumer<long[]> nodes, Consumer<int[]> leaves, Consumer<int[]> numbers) {
        TreeParts parts = TreeParts.of(TREE);
        TreeParts copy = new TreeParts(
                parts.nodes().clone(),
                parts.leafTriangles().clone(),
                parts.numbers().clone(),
                parts.depth());
        nodes.accept(copy.nodes());
        leaves.accept(copy.leafTriangles());
        numbers.accept(copy.numbers());
        return copy;
    }

    private static TreeParts nodes(Consumer<long[]> change) {
        return changed(change, leaves -> {}, numbers -> {});
    }

    private static void isRefused(TreeParts parts) {
        assertThatThrownBy(() -> parts.over(TREE.mesh(), TREE.costs())).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void theTreeOfStoredPartsIsTheTree() {
        for (TriangleMesh mesh : List.of(TREE.mesh(), TriangleMesh.of(new float[0], new int[0]))) {
            KDTree built = KDTree.of(mesh);
            KDTree restored = TreeParts.of(built).over(mesh, built.costs());

            assertThat(restored.nodes()).containsExactly(built.nodes());
            assertThat(restored.leafTriangles()).containsExactly(built.leafTriangles());
            assertThat(restored.triangles().corners())
                    .containsExactly(built.triangles().corners());
            assertThat(restored.triangles().numbers())
                    .containsExactly(built.triangles().numbers());
            assertThat(restored.rootBox()).containsExactly(built.rootBox());
            assertThat(restored.depth()).isEqualTo(built.depth());
            assertThat(restored.costs()).isEqualTo(built.costs());
        }
    }

    @Test
    void whatIsNoTreeIsRefused() {
        TreeParts parts = TreeParts.of(TREE);
        int last = parts.nodes().length - 1;
        int right = KDNode.rightChild(parts.nodes()[0]);

        isRefused(new TreeParts(new long[0], parts.leafTriangles(), parts.numbers(), parts.depth()));
        isRefused(new TreeParts(parts.nodes(), parts.leafTriangles(), parts.numbers(), parts.depth() + 1));
        isRefused(new TreeParts(parts.nodes(), parts.leafTriangles(), new int[3], parts.depth()));
        isRefused(new TreeParts(parts.nodes(), new int[3], parts.numbers(), parts.depth()));
        isRefused(nodes(all -> all[0] = KDNode.interior(0, 0, last + 1)));
        isRefused(nodes(all -> all[0] = KDNode.interior(0, 0, 1)));
        isRefused(nodes(all -> all[0] = KDNode.interior(0, 0, right + 1)));
        isRefused(nodes(all -> all[last] = KDNode.interior(0, 0, last)));
        isRefused(nodes(all -> all[last] = KDNode.leaf(parts.leafTriangles().length, 1)));
        isRefused(nodes(all -> all[last] = KDNode.leaf(0, 0) | 0x8000_0000L));
        isRefused(nodes(all -> all[0] = KDNode.leaf(0, 1)));
        isRefused(changed(all -> {}, leaves -> leaves[0] = -1, numbers -> {}));
        isRefused(changed(all -> {}, leaves -> leaves[0] = parts.numbers().length, numbers -> {}));
        isRefused(changed(all -> {}, leaves -> {}, numbers -> numbers[0] = numbers[1]));
        isRefused(changed(all -> {}, leaves -> {}, numbers -> numbers[0] = -1));
    }

    /** Rays end, whatever a tree that is not refused contains. */
    @Test
    void raysEndInEveryTreeThatIsNotRefused() {
        int kept = 0;
        for (int seed = 0; seed < 300; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            TreeParts parts = nodes(all -> all[random.nextInt(all.length)] ^= 1L << random.nextInt(64));
            try {
                KDTree tree = parts.over(TREE.mesh(), TREE.costs());
                kept++;
                Assertions.assertTimeoutPreemptively(
                        Duration.ofSeconds(20), () -> trace(tree, random), "bit changed by seed " + seed);
            } catch (IllegalArgumentException e) {
                assertThat(e).as("seed " + seed).hasMessageStartingWith("stored tree is damaged: ");
            }
        }
        assertThat(kept).isBetween(10, 290);
    }

    private static void trace(KDTree tree, SplittableRandom random) {
        StackTraversal traversal = new StackTraversal(tree);
        for (int i = 0; i < 50; i++) {
            double turn = 2.0 * Math.PI * random.nextDouble();
            double z = 2.0 * random.nextDouble() - 1.0;
            double flat = Math.sqrt(1.0 - z * z);
            traversal.closestHit(
                    0.0, 0.0, 0.0, flat * Math.cos(turn), flat * Math.sin(turn), z, 0.0, Double.POSITIVE_INFINITY);
        }
    }
}
