package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.jogamp.vecmath.Point3d;
import org.junit.jupiter.api.Test;

class AABBTest {
    private static final AABB BOX = new AABB(-1, 0, 2, 1, 4, 6);

    @Test
    void cornersAreNumberedByTheBitsOfTheirIndex() {
        assertThat(BOX.corners())
                .containsExactly(
                        new Point3d(-1, 0, 2),
                        new Point3d(1, 0, 2),
                        new Point3d(-1, 4, 2),
                        new Point3d(1, 4, 2),
                        new Point3d(-1, 0, 6),
                        new Point3d(1, 0, 6),
                        new Point3d(-1, 4, 6),
                        new Point3d(1, 4, 6));
    }

    @Test
    void measures() {
        assertThat(BOX.center()).isEqualTo(new Point3d(0, 2, 4));
        assertThat(BOX.diagonal()).isEqualTo(6.0);
        assertThat(BOX.surfaceArea()).isEqualTo(2.0 * (8 + 16 + 8));
    }

    @Test
    void aBoxFarFromTheOriginHasTheSizeOfOneThere() {
        AABB box = new AABB(100, -200, 300, 102, -197, 306);

        assertThat(box.diagonal()).isEqualTo(7.0);
        assertThat(box.surfaceArea()).isEqualTo(72.0);
    }

    @Test
    void containsItsBorder() {
        for (Point3d corner : BOX.corners()) {
            assertThat(BOX.contains(corner)).isTrue();
        }
        assertThat(BOX.contains(new Point3d(0, 2, 4))).isTrue();
    }

    @Test
    void doesNotContainWhatIsBesideItOnAnyAxis() {
        assertThat(BOX.contains(new Point3d(Math.nextUp(1.0), 2, 4))).isFalse();
        assertThat(BOX.contains(new Point3d(Math.nextDown(-1.0), 2, 4))).isFalse();
        assertThat(BOX.contains(new Point3d(0, Math.nextUp(4.0), 4))).isFalse();
        assertThat(BOX.contains(new Point3d(0, Math.nextDown(0.0), 4))).isFalse();
        assertThat(BOX.contains(new Point3d(0, 2, Math.nextUp(6.0)))).isFalse();
        assertThat(BOX.contains(new Point3d(0, 2, Math.nextDown(2.0)))).isFalse();
    }

    @Test
    void theUnionHoldsBoth() {
        assertThat(BOX.union(new AABB(0, -3, 3, 5, 1, 4))).isEqualTo(new AABB(-1, -3, 2, 5, 4, 6));
        assertThat(BOX.union(BOX)).isEqualTo(BOX);
    }

    @Test
    void isTheSmallestAroundPoints() {
        assertThat(AABB.around(List.of(new Position(1, 4, 2), new Position(-1, 0, 6), new Position(0, 2, 3))))
                .isEqualTo(BOX);
        assertThat(AABB.around(List.of(new Position(1, -2, 3)))).isEqualTo(new AABB(1, -2, 3, 1, -2, 3));
        assertThatIllegalArgumentException().isThrownBy(() -> AABB.around(List.of()));
    }

    @Test
    void growsOnAllSides() {
        assertThat(BOX.grown(0.5)).isEqualTo(new AABB(-1.5, -0.5, 1.5, 1.5, 4.5, 6.5));
    }

    @Test
    void mayBeFlatButNotInsideOut() {
        assertThat(new AABB(0, 0, 0, 0, 1, 1).surfaceArea()).isEqualTo(2.0);
        assertThatIllegalArgumentException().isThrownBy(() -> new AABB(1, 0, 0, 0, 1, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new AABB(0, 1, 0, 1, 0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new AABB(0, 0, 1, 1, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new AABB(0, 0, Double.NaN, 1, 1, 0));
    }
}
