package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.SplittableRandom;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PositionTest {
    private static final Position P = new Position(1, 2, 3);
    private static final Position Q = new Position(4, 6, 3);

    /** A record whose methods are generated. */
    private record Generated(double x, double y, double z) {}

    @Test
    void addsSubtractsAndScales() {
        assertThat(P.plus(Q)).isEqualTo(new Position(5, 8, 6));
        assertThat(Q.minus(P)).isEqualTo(new Position(3, 4, 0));
        assertThat(P.times(-2)).isEqualTo(new Position(-2, -4, -6));
    }

    @Test
    void measures() {
        assertThat(Q.minus(P).length()).isEqualTo(5.0);
        assertThat(P.distance(Q)).isEqualTo(5.0);
    }

    @Test
    void doesWhatVecmathDoes() {
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < 1000; i++) {
            Position a = new Position(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
            Position b = new Position(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
            Vector3d cross = new Vector3d();
            cross.cross(a.toVector3d(), b.toVector3d());
            Vector3d unit = a.toVector3d();
            unit.normalize();

            assertThat(a.cross(b)).isEqualTo(Position.of(cross));
            assertThat(a.unit()).isEqualTo(Position.of(unit));
            assertThat(a.angle(b)).isEqualTo(a.toVector3d().angle(b.toVector3d()));
        }
        assertThat(P.angle(P.times(3.0))).isEqualTo(0.0);
        assertThat(P.angle(P.times(-0.1))).isEqualTo(Math.PI);
        assertThatIllegalArgumentException().isThrownBy(() -> P.minus(P).unit());
    }

    @Test
    void goesToVecmathAndBack() {
        assertThat(P.toPoint3d()).isEqualTo(new Point3d(1, 2, 3));
        assertThat(P.toVector3d()).isEqualTo(new Vector3d(1, 2, 3));
        assertThat(Position.of(P.toPoint3d())).isEqualTo(P);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void refusesWhatIsNoPlace(double bad) {
        assertThatIllegalArgumentException().isThrownBy(() -> new Position(bad, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Position(0, bad, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Position(0, 0, bad));
    }

    @Test
    void equalsAsAGeneratedRecordDoes() {
        double[] values = {0.0, -0.0, 1.0, Double.MIN_VALUE, -Double.MAX_VALUE};
        for (int i = 0; i < 125 * 125; i++) {
            double[] c = new double[6];
            for (int k = 0, rest = i; k < 6; k++, rest /= 5) {
                c[k] = values[rest % 5];
            }
            Position one = new Position(c[0], c[1], c[2]);
            Position other = new Position(c[3], c[4], c[5]);
            Generated likeOne = new Generated(c[0], c[1], c[2]);

            assertThat(one.equals(other))
                    .as("%s and %s", one, other)
                    .isEqualTo(likeOne.equals(new Generated(c[3], c[4], c[5])));
            assertThat(one.hashCode()).as("%s", one).isEqualTo(likeOne.hashCode());
        }
    }

    @Test
    void equalsNothingOfAnotherKind() {
        assertThat(P.equals(null)).isFalse();
        assertThat(P.equals((Object) P.toPoint3d())).isFalse();
    }
}
