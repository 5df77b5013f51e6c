package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KDNodeTest {

    @ParameterizedTest
    @ValueSource(
            floats = {0f, 1f, -1f, 0.1f, -0.1f, 1e30f, -1e30f, 1e-30f, -1e-30f, 1e-44f, -1e-44f, 3.4e38f, -3.4e38f})
    void interiorNodesKeepAxisPlaneAndChild(float coordinate) {
        for (int axis = 0; axis < 3; axis++) {
            for (int right : new int[] {1, 2, 12345, Integer.MAX_VALUE}) {
                int key = KDNode.floorKey(coordinate);
                long node = KDNode.interior(axis, key, right);

                assertThat(KDNode.kind(node)).isEqualTo(axis);
                assertThat(KDNode.split(node)).isEqualTo(KDNode.value(key));
                assertThat(KDNode.rightChild(node)).isEqualTo(right);
            }
        }
    }

    @Test
    void leavesKeepTheirFirstEntryAndTheirCount() {
        for (int first : new int[] {0, 1, 54321, Integer.MAX_VALUE}) {
            for (int count : new int[] {0, 1, 17, KDNode.MAX_COUNT}) {
                long leaf = KDNode.leaf(first, count);

                assertThat(KDNode.kind(leaf)).isEqualTo(KDNode.LEAF);
                assertThat(KDNode.first(leaf)).isEqualTo(first);
                assertThat(KDNode.count(leaf)).isEqualTo(count);
            }
        }
    }

    @Test
    void whatDoesNotFitIsRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> KDNode.interior(-1, 0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> KDNode.interior(KDNode.LEAF, 0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> KDNode.interior(0, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> KDNode.leaf(-1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> KDNode.leaf(0, -1));
        assertThatIllegalArgumentException().isThrownBy(() -> KDNode.leaf(0, KDNode.MAX_COUNT + 1));
    }

    @Test
    void keysEncloseACoordinateAsTightlyAsTheGridAllows() {
        SplittableRandom random = new SplittableRandom(90);
        for (int i = 0; i < 200_000; i++) {
            double coordinate = randomCoordinate(random);
            int floor = KDNode.floorKey(coordinate);
            int ceil = KDNode.ceilKey(coordinate);

            assertThat((double) KDNode.value(floor)).isLessThanOrEqualTo(coordinate);
            assertThat((double) KDNode.value(ceil)).isGreaterThanOrEqualTo(coordinate);
            assertThat((double) KDNode.value(floor + 1)).isGreaterThan(coordinate);
            assertThat((double) KDNode.value(ceil - 1)).isLessThan(coordinate);
        }
    }

    /** A number of any magnitude up to 1e30, half of the time a float, of either sign. */
    private static double randomCoordinate(SplittableRandom random) {
        double magnitude = random.nextDouble() * Math.pow(10, 75 * random.nextDouble() - 45);
        double coordinate = random.nextBoolean() ? magnitude : -magnitude;
        return random.nextBoolean() ? (float) coordinate : coordinate;
    }

    @Test
    void valuesOfTheGridHaveTwoZeroBitsAndAscend() {
        SplittableRandom random = new SplittableRandom(91);
        for (int i = 0; i < 100_000; i++) {
            int key = KDNode.floorKey(randomCoordinate(random));
            float value = KDNode.value(key);

            assertThat(Float.floatToRawIntBits(value) & 3).isZero();
            assertThat(KDNode.value(key + 1)).isGreaterThan(value);
            assertThat(KDNode.floorKey(value)).isEqualTo(key);
            assertThat(KDNode.ceilKey(value)).isEqualTo(key);
        }
    }

    @Test
    void bothZerosAreTheSamePlane() {
        assertThat(KDNode.floorKey(-0.0)).isZero();
        assertThat(KDNode.ceilKey(-0.0)).isZero();
        assertThat(Float.floatToRawIntBits(KDNode.value(0))).isZero();
        assertThat(KDNode.value(KDNode.floorKey(-Double.MIN_VALUE))).isEqualTo(-4 * Float.MIN_VALUE);
        assertThat(KDNode.value(KDNode.ceilKey(Double.MIN_VALUE))).isEqualTo(4 * Float.MIN_VALUE);
    }

    @Test
    void eventsSortByPlaneThenKind() {
        int key = KDNode.floorKey(-7.5);

        assertThat(KDNode.eventKey(KDNode.event(key, 2))).isEqualTo(key);
        assertThat(KDNode.eventType(KDNode.event(key, 2))).isEqualTo(2);
        assertThat(KDNode.event(key, 0)).isLessThan(KDNode.event(key, 1));
        assertThat(KDNode.event(key, 2)).isLessThan(KDNode.event(key + 1, 0));
        assertThat(KDNode.event(KDNode.floorKey(-1e30), 2)).isLessThan(KDNode.event(KDNode.floorKey(1e30), 0));
    }
}
