package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Which of equally cheap planes is kept: always the same, whichever came first. */
class CheapestSplitTest {
    private static final int LOW = KDNode.floorKey(-1);
    private static final int HIGH = KDNode.floorKey(1);
    private static final int LOWER = KDNode.floorKey(-0.5);
    private static final int UPPER = KDNode.floorKey(0.5);

    private final CheapestSplit best = new CheapestSplit(SahCost.DEFAULT);

    private void begin() {
        assertThat(best.begin(new int[] {LOW, LOW, LOW, HIGH, HIGH, HIGH})).isTrue();
    }

    private void tryPlane(int axis, int key) {
        best.setAxis(axis);
        best.tryPlane(key, 5, 0, 5);
    }

    @Test
    void thatOnTheFirstAxis() {
        begin();
        tryPlane(1, LOWER);
        tryPlane(2, LOWER);
        assertThat(best.split().orElseThrow().axis()).isEqualTo(1);
        tryPlane(0, LOWER);
        assertThat(best.split().orElseThrow().axis()).isZero();
        tryPlane(1, LOWER);
        assertThat(best.split().orElseThrow().axis()).isZero();
    }

    @Test
    void thereTheLowest() {
        for (int[] order : new int[][] {{LOWER, UPPER}, {UPPER, LOWER}}) {
            begin();
            tryPlane(0, order[0]);
            tryPlane(0, order[1]);
            assertThat(best.split().orElseThrow().key()).isEqualTo(LOWER);
        }
    }

    /** Triangles in the plane go to its cheaper side, the left one where both cost the same. */
    @Test
    void trianglesInThePlaneGoToTheLeft() {
        begin();
        best.setAxis(0);
        best.tryPlane(KDNode.floorKey(0), 5, 3, 5);
        assertThat(best.split().orElseThrow().planarLeft()).isTrue();
        begin();
        best.setAxis(0);
        best.tryPlane(LOWER, 5, 3, 5);
        assertThat(best.split().orElseThrow().planarLeft())
                .as("the smaller side")
                .isTrue();
        begin();
        best.setAxis(0);
        best.tryPlane(UPPER, 5, 3, 5);
        assertThat(best.split().orElseThrow().planarLeft())
                .as("the smaller side")
                .isFalse();
    }

    @Test
    void noneThatDoesNotLieInside() {
        begin();
        tryPlane(0, LOW);
        tryPlane(0, HIGH);
        assertThat(best.split()).isEmpty();
        assertThat(best.cost()).isInfinite();
    }
}
