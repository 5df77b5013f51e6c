package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Walks a finished tree and asserts what must hold of any: its shape, that no part of a triangle is lost, and that its
 * statistics are true.
 */
final class TreeValidator {
    /** A part of a triangle below this share of its area may be rounding. */
    private static final double ROUNDING = 1e-9;
    /** Area below which a triangle's square underflows a double: its share cannot be judged. */
    private static final double LEAST_AREA = 1e-150;

    private final String name;
    private final KDTree tree;
    private final TriangleMesh mesh;
    private final BitSet seenNodes = new BitSet();
    private final BitSet seenEntries = new BitSet();
    private final double[] coveredArea;
    private final double[] fullArea;
    private final double rootSurface;

    private int leaves;
    private int emptyLeaves;
    private int maxLeafSize;
    private int depth;
    private double cost;
    private double volume;

    private TreeValidator(String name, KDTree tree) {
        this.name = name;
        this.tree = tree;
        this.mesh = tree.mesh();
        this.coveredArea = new double[mesh.triangleCount()];
        this.fullArea = new double[mesh.triangleCount()];
        this.rootSurface = halfSurface(rootBox());
    }

    /** Asserts all that must hold of a tree. */
    static void validate(String name, KDTree tree) {
        TreeValidator validator = new TreeValidator(name, tree);
        validator.checkRoot();
        int[] all = IntStream.range(0, tree.mesh().triangleCount()).toArray();
        validator.visit(0, validator.rootBox(), 0, all);
        validator.checkPlaces();
        validator.checkTotals();
        validator.checkStatistics();
    }

    private double[] rootBox() {
        double[] box = new double[6];
        Arrays.setAll(box, k -> tree.rootBox()[k]);
        return box;
    }

    private void checkRoot() {
        for (int i = 0; i < mesh.triangleCount(); i++) {
            List<double[]> inside = Polygons.clip(mesh, i, rootBox());
            fullArea[i] = mesh.triangle(i).area();
            assertThat(Polygons.area(inside))
                    .as("%s: part of triangle %d in the root's box", name, i)
                    .isEqualTo(Polygons.area(Polygons.clip(mesh, i, everywhere())));
        }
    }

    private static double[] everywhere() {
        double end = Double.POSITIVE_INFINITY;
        return new double[] {-end, -end, -end, end, end, end};
    }

    private void visit(int index, double[] box, int level, int[] candidates) {
        assertThat(index).as("%s: node index", name).isBetween(0, tree.nodes().length - 1);
        assertThat(seenNodes.get(index))
                .as("%s: node %d was met before", name, index)
                .isFalse();
        seenNodes.set(index);
        depth = Math.max(depth, level);
        long node = tree.nodes()[index];
        double share = rootSurface > 0.0 ? halfSurface(box) / rootSurface : 1.0;
        if (KDNode.kind(node) == KDNode.LEAF) {
            cost += share * tree.costs().intersection() * KDNode.count(node);
            visitLeaf(node, box, candidates);
            return;
        }
        cost += share * tree.costs().traversal();
        int axis = KDNode.kind(node);
        double split = KDNode.split(node);
        assertThat(split)
                .as("%s: split of node %d on axis %d", name, index, axis)
                .isGreaterThan(box[axis])
                .isLessThan(box[axis + 3]);
        double[] left = box.clone();
        left[axis + 3] = split;
        double[] right = box.clone();
        right[axis] = split;
        visit(KDNode.leftChild(index), left, level + 1, touching(candidates, left));
        visit(KDNode.rightChild(node), right, level + 1, touching(candidates, right));
    }

    private int[] touching(int[] candidates, double[] box) {
        return Arrays.stream(candidates).filter(i -> touches(i, box, 0)).toArray();
    }

    /** Whether a triangle's bounds meet a box that is made larger by so many units in the last place. */
    private boolean touches(int triangle, double[] box, int ulps) {
        for (int axis = 0; axis < 3; axis++) {
            float a = mesh.coordinate(triangle, 0, axis);
            float b = mesh.coordinate(triangle, 1, axis);
            float c = mesh.coordinate(triangle, 2, axis);
            double low = Math.min(a, Math.min(b, c));
            double high = Math.max(a, Math.max(b, c));
            double slackLow = ulps * Math.ulp((float) box[axis]);
            double slackHigh = ulps * Math.ulp((float) box[axis + 3]);
            if (high < box[axis] - slackLow || low > box[axis + 3] + slackHigh) {
                return false;
            }
        }
        return true;
    }

    private void visitLeaf(long leaf, double[] box, int[] candidates) {
        int first = KDNode.first(leaf);
        int count = KDNode.count(leaf);
        leaves++;
        emptyLeaves += count == 0 ? 1 : 0;
        maxLeafSize = Math.max(maxLeafSize, count);
        volume += (box[3] - box[0]) * (box[4] - box[1]) * (box[5] - box[2]);
        assertThat(first + count).as("%s: end of a leaf's entries", name).isBetween(0, tree.leafTriangles().length);

        BitSet listed = new BitSet();
        for (int entry = first; entry < first + count; entry++) {
            int place = tree.leafTriangles()[entry];
            assertThat(place).as("%s: entry %d", name, entry).isBetween(0, mesh.triangleCount() - 1);
            int triangle = tree.triangles().numbers()[place];
            assertThat(seenEntries.get(entry))
                    .as("%s: entry %d is shared", name, entry)
                    .isFalse();
            assertThat(listed.get(triangle))
                    .as("%s: triangle %d twice in a leaf", name, triangle)
                    .isFalse();
            assertThat(touches(triangle, box, 4))
                    .as("%s: triangle %d far from its leaf", name, triangle)
                    .isTrue();
            seenEntries.set(entry);
            listed.set(triangle);
            coveredArea[triangle] += Polygons.area(Polygons.clip(mesh, triangle, box));
        }
        for (int triangle : candidates) {
            if (!listed.get(triangle)) {
                checkMayBeMissing(triangle, box);
            }
        }
    }

    /** A triangle outside a leaf's list has no area in the leaf, or lies in a face and belongs to the leaf behind. */
    private void checkMayBeMissing(int triangle, double[] box) {
        List<double[]> part = Polygons.clip(mesh, triangle, box);
        if (part.isEmpty() || Polygons.area(part) <= ROUNDING * fullArea[triangle]) {
            return;
        }
        double[] bounds = Polygons.bounds(part);
        boolean inFace = IntStream.range(0, 3)
                .anyMatch(k -> bounds[k] == bounds[k + 3] && (bounds[k] == box[k] || bounds[k] == box[k + 3]));
        assertThat(inFace)
                .as("%s: triangle %d is missing in the leaf %s", name, triangle, Arrays.toString(box))
                .isTrue();
    }

    private void checkTotals() {
        assertThat(seenNodes.cardinality()).as("%s: nodes reached", name).isEqualTo(tree.nodes().length);
        assertThat(seenEntries.cardinality()).as("%s: leaf entries", name).isEqualTo(tree.leafTriangles().length);
        double[] box = rootBox();
        double whole = (box[3] - box[0]) * (box[4] - box[1]) * (box[5] - box[2]);
        assertThat(volume).as("%s: volume of all leaves", name).isCloseTo(whole, withinPercentage(1e-6));
        for (int i = 0; i < mesh.triangleCount(); i++) {
            if (fullArea[i] > LEAST_AREA) {
                assertThat(coveredArea[i])
                        .as("%s: area of triangle %d in all leaves that list it", name, i)
                        .isGreaterThanOrEqualTo((1 - 1e-6) * fullArea[i]);
            }
        }
    }

    /** Every triangle has one place, in the order in which leaves come to it, and takes its corners along. */
    private void checkPlaces() {
        int[] numbers = tree.triangles().numbers();
        assertThat(IntStream.of(numbers).sorted())
                .as("%s: numbers", name)
                .containsExactly(
                        IntStream.range(0, mesh.triangleCount()).boxed().toArray(Integer[]::new));
        int seen = 0;
        for (int place : tree.leafTriangles()) {
            assertThat(place).as("%s: places", name).isLessThanOrEqualTo(seen);
            seen = Math.max(seen, place + 1);
        }
        for (int i = 0; i < 9 * numbers.length; i++) {
            assertThat(tree.triangles().corners()[i])
                    .as("%s: corners of triangle %d", name, numbers[i / 9])
                    .isEqualTo(mesh.coordinate(numbers[i / 9], i / 3 % 3, i % 3));
        }
    }

    private void checkStatistics() {
        KDTreeStats stats = KDTreeStats.of(tree);
        int entries = tree.leafTriangles().length;
        int filled = leaves - emptyLeaves;
        assertThat(stats)
                .as("%s: statistics", name)
                .returns(mesh.triangleCount(), KDTreeStats::triangles)
                .returns(tree.nodes().length, KDTreeStats::nodes)
                .returns(leaves, KDTreeStats::leaves)
                .returns(emptyLeaves, KDTreeStats::emptyLeaves)
                .returns(filled == 0 ? 0.0 : (double) entries / filled, KDTreeStats::meanLeafSize)
                .returns(maxLeafSize, KDTreeStats::maxLeafSize)
                .returns(depth, KDTreeStats::depth)
                .returns(8L * tree.nodes().length + 4L * entries + 40L * mesh.triangleCount(), KDTreeStats::bytes);
        assertThat(stats.sahCost()).as("%s: cost", name).isCloseTo(cost, withinPercentage(1e-7));
        assertThat(leaves).as("%s: leaves of a binary tree", name).isEqualTo(tree.nodes().length / 2 + 1);
        double limit = 8.0 + 1.3 * Math.log(Math.max(1, mesh.triangleCount())) / Math.log(2.0);
        assertThat((double) depth).as("%s: depth", name).isLessThanOrEqualTo(limit);
    }

    private static double halfSurface(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x * y + y * z + z * x;
    }
}
