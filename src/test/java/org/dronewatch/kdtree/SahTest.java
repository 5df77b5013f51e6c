package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

/** Splits against the surface area heuristic, worked out plane by plane. */
class SahTest {
    private static final int ORIGIN = KDNode.floorKey(1.0);

    /** A voxel of so many grid steps on each axis, with one corner at (1, 1, 1). */
    private static int[] voxel(int x, int y, int z) {
        return new int[] {ORIGIN, ORIGIN, ORIGIN, ORIGIN + x, ORIGIN + y, ORIGIN + z};
    }

    /** Boxes on the grid; about a quarter of their sides have no width, some of these lie in the voxel's faces. */
    private static int[] randomBoxes(int count, int reach, SplittableRandom random) {
        int[] boxes = new int[6 * count];
        for (int i = 0; i < 3 * count; i++) {
            boolean flat = random.nextInt(4) == 0;
            int low = !flat
                    ? random.nextInt(reach)
                    : random.nextInt(8) > 0 ? random.nextInt(reach + 1) : reach * random.nextInt(2);
            int high = flat ? low : low + 1 + random.nextInt(reach - low);
            int slot = 6 * (i / 3) + i % 3;
            boxes[slot] = ORIGIN + low;
            boxes[slot + 3] = ORIGIN + high;
        }
        return boxes;
    }

    /** Cost of a split by its definition, with flat boxes in the plane on the side that is cheaper. */
    private static double cost(int axis, int key, int[] boxes, int[] voxel) {
        int left = 0;
        int right = 0;
        int flat = 0;
        for (int i = 0; i < boxes.length; i += 6) {
            boolean inPlane = boxes[i + axis] == key && boxes[i + axis + 3] == key;
            flat += inPlane ? 1 : 0;
            left += boxes[i + axis] < key ? 1 : 0;
            right += boxes[i + axis + 3] > key ? 1 : 0;
        }
        int[] leftVoxel = voxel.clone();
        leftVoxel[axis + 3] = key;
        int[] rightVoxel = voxel.clone();
        rightVoxel[axis] = key;
        double leftShare = surface(leftVoxel) / surface(voxel);
        double rightShare = surface(rightVoxel) / surface(voxel);
        return Math.min(
                cost(leftShare, rightShare, left + flat, right), cost(leftShare, rightShare, left, right + flat));
    }

    private static double cost(double leftShare, double rightShare, int left, int right) {
        return (left * right == 0 ? 0.8 : 1.0) * (4.0 + 1.5 * (leftShare * left + rightShare * right));
    }

    private static double surface(int[] keys) {
        double x = (double) KDNode.value(keys[3]) - KDNode.value(keys[0]);
        double y = (double) KDNode.value(keys[4]) - KDNode.value(keys[1]);
        double z = (double) KDNode.value(keys[5]) - KDNode.value(keys[2]);
        return 2 * (x * y + y * z + z * x);
    }

    /**
     * The least cost over all planes strictly inside a voxel at which some box begins or ends, or one step inside a
     * face in which some box lies; infinity for none.
     */
    private static double leastCost(int[] boxes, int[] voxel) {
        double least = Double.POSITIVE_INFINITY;
        for (int a = 0; a < 3; a++) {
            int axis = a;
            TreeSet<Integer> planes = new TreeSet<>();
            for (int i = axis; i < boxes.length; i += 3) {
                if (i % 3 == axis) {
                    planes.add(boxes[i]);
                }
            }
            for (int i = axis; i < boxes.length; i += 6) {
                if (boxes[i] == boxes[i + 3]) {
                    planes.add(boxes[i] == voxel[axis] ? boxes[i] + 1 : boxes[i]);
                    planes.add(boxes[i] == voxel[axis + 3] ? boxes[i] - 1 : boxes[i]);
                }
            }
            planes.removeIf(key -> key <= voxel[axis] || key >= voxel[axis + 3]);
            for (int key : planes) {
                least = Math.min(least, cost(axis, key, boxes, voxel));
            }
        }
        return least;
    }

    @Test
    void theSplitFoundIsTheCheapestOfAllPlanes() {
        SplittableRandom random = new SplittableRandom(80);
        for (int round = 0; round < 3000; round++) {
            int reach = 2 + random.nextInt(60);
            int count = 1 + random.nextInt(40);
            int[] boxes = randomBoxes(count, reach, random);
            int[] voxel = voxel(reach, reach, reach);

            Optional<Split> split = new SahSplitFinder(SahCost.DEFAULT).find(boxes, count, voxel);

            double least = leastCost(boxes, voxel);
            String what = "round " + round + " of seed 80";
            assertThat(split.isPresent()).as(what).isEqualTo(least < Double.POSITIVE_INFINITY);
            if (split.isPresent()) {
                double own = cost(split.get().axis(), split.get().key(), boxes, voxel);
                assertThat(split.get().cost()).as(what).isCloseTo(least, withinPercentage(1e-10));
                assertThat(own).as(what).isCloseTo(least, withinPercentage(1e-10));
            }
        }
    }

    @Test
    void noPlaneBetweenTheCandidatesIsCheaperThanBothALeafAndTheBestSplit() {
        SplittableRandom random = new SplittableRandom(81);
        for (int round = 0; round < 2000; round++) {
            int count = 1 + random.nextInt(12);
            int[] boxes = randomBoxes(count, 20, random);
            int[] voxel = voxel(20, 20, 20);
            double best = new SahSplitFinder(SahCost.DEFAULT)
                    .find(boxes, count, voxel)
                    .map(Split::cost)
                    .orElse(Double.MAX_VALUE);
            for (int axis = 0; axis < 3; axis++) {
                for (int key = ORIGIN + 1; key < ORIGIN + 20; key++) {
                    assertThat(cost(axis, key, boxes, voxel))
                            .as("round %d of seed 81, axis %d", round, axis)
                            .isGreaterThanOrEqualTo(Math.min(best, 1.5 * count) - 1e-9);
                }
            }
        }
    }

    /** So many that they are counted in slices first; planes by the thousand, many of them shared, some crowded. */
    @Test
    void theSplitOfManyTrianglesIsTheCheapestOfAllPlanes() {
        SplittableRandom random = new SplittableRandom(85);
        for (int round = 0; round < 150; round++) {
            int reach = round % 3 == 0 ? 50 : 5_000_000;
            int count = 64 + random.nextInt(400);
            int[] boxes = randomBoxes(count, reach, random);
            if (round % 5 == 0) {
                crowd(boxes, reach);
            }
            int[] voxel = voxel(reach, reach, reach);

            Split split = new SahSplitFinder(SahCost.DEFAULT)
                    .find(boxes, count, voxel)
                    .orElseThrow();

            double own = cost(split.axis(), split.key(), boxes, voxel);
            String what = "round " + round + " of seed 85";
            assertThat(split.cost()).as(what).isCloseTo(own, withinPercentage(1e-10));
            assertThat(own).as(what).isCloseTo(leastCost(boxes, voxel), withinPercentage(1e-10));
        }
    }

    /** Puts most boxes into a small part of the voxel. */
    private static void crowd(int[] boxes, int reach) {
        for (int i = 0; i < boxes.length / 6 * 5; i++) {
            boxes[i] = ORIGIN + reach / 3 + (boxes[i] - ORIGIN) / 40;
        }
    }

    @Test
    void emptySpaceIsCutOffAtADiscount() {
        int[] box = {ORIGIN + 48, ORIGIN, ORIGIN, ORIGIN + 64, ORIGIN + 64, ORIGIN + 64};

        Split split = new SahSplitFinder(SahCost.DEFAULT)
                .find(box, 1, voxel(64, 64, 64))
                .orElseThrow();

        // A quarter of a cube has half of its surface.
        assertThat(split.axis()).isZero();
        assertThat(split.key()).isEqualTo(ORIGIN + 48);
        assertThat(split.cost()).isCloseTo(0.8 * (4.0 + 1.5 * 0.5), within(1e-12));
    }

    @Test
    void trianglesInTheSplitPlaneGoToTheCheaperSide() {
        for (int plane : new int[] {16, 48}) {
            int[] flat = {ORIGIN + plane, ORIGIN, ORIGIN, ORIGIN + plane, ORIGIN + 64, ORIGIN + 64};

            Split split = new SahSplitFinder(SahCost.DEFAULT)
                    .find(flat, 1, voxel(64, 64, 64))
                    .orElseThrow();

            assertThat(split.planarLeft()).isEqualTo(plane == 16);
            assertThat(split.isLeft(ORIGIN + plane, ORIGIN + plane)).isEqualTo(plane == 16);
            assertThat(split.isRight(ORIGIN + plane, ORIGIN + plane)).isEqualTo(plane == 48);
            assertThat(split.cost()).isCloseTo(0.8 * (4.0 + 1.5 * 0.5), within(1e-12));
        }
    }

    /** A floor at the bottom of a voxel, a ceiling at its top: else rays through the air between would test them. */
    @Test
    void whatLiesInAFaceIsCutOffFromTheAirBeforeIt() {
        for (int plane : new int[] {0, 64}) {
            int[] flat = {ORIGIN, ORIGIN + plane, ORIGIN, ORIGIN + 64, ORIGIN + plane, ORIGIN + 64};
            int[] twenty = new int[120];
            Arrays.setAll(twenty, i -> flat[i % 6]);

            Split split = new SahSplitFinder(SahCost.DEFAULT)
                    .find(twenty, 20, voxel(64, 64, 64))
                    .orElseThrow();

            assertThat(split.axis()).isEqualTo(1);
            assertThat(split.key()).isEqualTo(plane == 0 ? ORIGIN + 1 : ORIGIN + 63);
            // A slice of one step has two of the cube's six faces, and borders of 4 / 64 of a face.
            assertThat(split.cost()).isCloseTo(0.8 * (4.0 + 1.5 * 20 * (2.0 + 4.0 / 64) / 6.0), within(1e-9));
        }
    }

    @Test
    void boxesThatTouchThePlaneStayOnTheirSide() {
        Split split = new Split(0, 10, true, 1.0);

        assertThat(split.isLeft(3, 10)).isTrue();
        assertThat(split.isRight(3, 10)).isFalse();
        assertThat(split.isLeft(10, 12)).isFalse();
        assertThat(split.isRight(10, 12)).isTrue();
        assertThat(split.isLeft(9, 11) && split.isRight(9, 11)).isTrue();
    }

    @Test
    void aVoxelWithoutSurfaceOrWithoutInnerPlaneIsNotSplit() {
        int[] across = {ORIGIN, ORIGIN, ORIGIN, ORIGIN + 4, ORIGIN, ORIGIN};
        int[] half = {ORIGIN, ORIGIN, ORIGIN, ORIGIN + 2, ORIGIN, ORIGIN};

        assertThat(new SahSplitFinder(SahCost.DEFAULT).find(half, 1, across)).isEmpty();
        assertThat(new SahSplitFinder(SahCost.DEFAULT).find(voxel(1, 1, 1), 1, voxel(1, 1, 1)))
                .isEmpty();
    }

    @Test
    void everyNodeOfATreeIsSplitAtItsCheapestPlaneOrALeafBecauseNoneIsWorthIt() {
        for (int seed = 82; seed < 122; seed++) {
            TriangleMesh mesh = Meshes.soup(10 + seed % 40, 0.1 + 0.1 * (seed % 7), seed);
            KDTree tree = KDTree.of(mesh);
            int[] root = new int[6];
            Arrays.setAll(root, k -> KDNode.floorKey(tree.rootBox()[k]));
            List<Integer> all = new ArrayList<>();
            for (int i = 0; i < mesh.triangleCount(); i++) {
                all.add(i);
            }
            checkNode(tree, 0, root, all, 0, "seed " + seed);
        }
    }

    private static void checkNode(
            KDTree tree, int index, int[] voxel, List<Integer> triangles, int level, String what) {
        int[] boxes = new int[6 * triangles.size()];
        for (int i = 0; i < triangles.size(); i++) {
            System.arraycopy(clippedBox(tree.mesh(), triangles.get(i), voxel), 0, boxes, 6 * i, 6);
        }
        double least = leastCost(boxes, voxel);
        long node = tree.nodes()[index];
        int axis = KDNode.kind(node);
        if (axis == KDNode.LEAF) {
            int first = KDNode.first(node);
            assertThat(IntStream.range(first, first + KDNode.count(node))
                            .map(i -> tree.triangles().numbers()[tree.leafTriangles()[i]]))
                    .as("%s: leaf at node %d", what, index)
                    .containsExactly(triangles.toArray(Integer[]::new));
            if (level < KDTreeBuilder.depthLimit(tree.mesh().triangleCount())) {
                assertThat(least).as("%s: best split of leaf %d", what, index).isGreaterThan(1.5 * triangles.size());
            }
            return;
        }
        int key = KDNode.floorKey(KDNode.split(node));
        assertThat(cost(axis, key, boxes, voxel))
                .as("%s: node %d on axis %d", what, index, axis)
                .isCloseTo(least, withinPercentage(1e-9))
                .isLessThanOrEqualTo(1.5 * triangles.size());
        List<Integer> left = new ArrayList<>();
        List<Integer> right = new ArrayList<>();
        for (int i = 0; i < triangles.size(); i++) {
            if (boxes[6 * i + axis] < key) {
                left.add(triangles.get(i));
            }
            if (boxes[6 * i + axis + 3] > key) {
                right.add(triangles.get(i));
            }
        }
        int[] leftVoxel = voxel.clone();
        leftVoxel[axis + 3] = key;
        int[] rightVoxel = voxel.clone();
        rightVoxel[axis] = key;
        checkNode(tree, KDNode.leftChild(index), leftVoxel, left, level + 1, what);
        checkNode(tree, KDNode.rightChild(node), rightVoxel, right, level + 1, what);
    }

    private static int[] clippedBox(TriangleMesh mesh, int triangle, int[] voxel) {
        double[] box = new double[6];
        Arrays.setAll(box, k -> KDNode.value(voxel[k]));
        double[] bounds = Polygons.bounds(Polygons.clip(mesh, triangle, box));
        int[] keys = new int[6];
        for (int axis = 0; axis < 3; axis++) {
            keys[axis] = Math.max(voxel[axis], KDNode.floorKey(bounds[axis]));
            keys[axis + 3] = Math.min(voxel[axis + 3], KDNode.ceilKey(bounds[axis + 3]));
        }
        return keys;
    }
}
