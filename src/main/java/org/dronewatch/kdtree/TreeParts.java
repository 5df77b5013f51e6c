package org.dronewatch.kdtree;

import java.util.BitSet;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The parts of a tree that have to be stored so that it need not be built again; the rest follows from its mesh. The
 * arrays are shared with the tree, and not written to.
 *
 * @param nodes packed nodes, the root first, each left child next to its parent
 * @param leafTriangles indices of triangles in leaf order, leaf by leaf
 * @param numbers the triangles' numbers in the mesh, in leaf order
 * @param depth the largest number of splits above a leaf
 */
public record TreeParts(long[] nodes, int[] leafTriangles, int[] numbers, int depth) {
    /** The parts of a tree. */
    public static TreeParts of(KDTree tree) {
        return new TreeParts(
                tree.nodes(), tree.leafTriangles(), tree.triangles().numbers(), tree.depth());
    }

    /**
     * The tree over a mesh. No traversal of the tree leaves its arrays or fails to terminate, whatever the parts
     * contain; whether they belong to the mesh cannot be checked.
     *
     * @param costs costs with which the tree was built
     * @throws IllegalArgumentException if the parts do not form a tree over as many triangles as the mesh has
     */
    public KDTree over(TriangleMesh mesh, SahCost costs) {
        checkNumbers(mesh.triangleCount());
        checkNodes();
        LeafOrderTriangles triangles = new LeafOrderTriangles(corners(mesh), numbers);
        return new KDTree(mesh, costs, nodes, leafTriangles, triangles, rootBox(mesh), depth);
    }

    private float[] corners(TriangleMesh mesh) {
        float[] vertices = mesh.vertices();
        int[] indices = mesh.corners();
        float[] corners = new float[9 * numbers.length];
        int next = 0;
        for (int number : numbers) {
            for (int k = 3 * number; k < 3 * number + 3; k++) {
                int vertex = 3 * indices[k];
                corners[next++] = vertices[vertex];
                corners[next++] = vertices[vertex + 1];
                corners[next++] = vertices[vertex + 2];
            }
        }
        return corners;
    }

    /** The box of a root: the mesh's bounds on the grid of split planes. */
    private static float[] rootBox(TriangleMesh mesh) {
        if (mesh.triangleCount() == 0) {
            return new float[SahSplitFinder.BOX];
        }
        AABB box = mesh.bounds();
        return new float[] {
            KDNode.value(KDNode.floorKey(box.minX())),
            KDNode.value(KDNode.floorKey(box.minY())),
            KDNode.value(KDNode.floorKey(box.minZ())),
            KDNode.value(KDNode.ceilKey(box.maxX())),
            KDNode.value(KDNode.ceilKey(box.maxY())),
            KDNode.value(KDNode.ceilKey(box.maxZ()))
        };
    }

    private void checkNumbers(int count) {
        check(numbers.length == count, "numbers of triangles");
        BitSet found = new BitSet(count);
        for (int number : numbers) {
            check(number >= 0 && number < count && !found.get(number), "number of a triangle");
            found.set(number);
        }
        for (int triangle : leafTriangles) {
            check(triangle >= 0 && triangle < count, "triangle of a leaf");
        }
    }

    /** Every node but the root has one parent, which comes before it: there are no cycles. */
    private void checkNodes() {
        check(nodes.length > 0, "root");
        byte[] levels = new byte[nodes.length];
        BitSet reached = new BitSet(nodes.length);
        reached.set(0);
        int deepest = 0;
        for (int i = 0; i < nodes.length; i++) {
            check(reached.get(i), "node without a parent");
            long node = nodes[i];
            if (KDNode.kind(node) == KDNode.LEAF) {
                int first = KDNode.first(node);
                check(first >= 0 && KDNode.count(node) <= leafTriangles.length - first, "leaf");
                deepest = Math.max(deepest, levels[i]);
            } else {
                int right = KDNode.rightChild(node);
                boolean isInside = right > i + 1 && right < nodes.length;
                check(isInside && levels[i] < Byte.MAX_VALUE, "interior node");
                check(!reached.get(i + 1) && !reached.get(right), "node with two parents");
                check(Float.isFinite(KDNode.split(node)), "split plane");
                reached.set(i + 1);
                reached.set(right);
                levels[i + 1] = (byte) (levels[i] + 1);
                levels[right] = levels[i + 1];
            }
        }
        check(deepest == depth, "depth");
    }

    private static void check(boolean isRight, String what) {
        if (!isRight) {
            throw new IllegalArgumentException("stored tree is damaged: " + what);
        }
    }
}
