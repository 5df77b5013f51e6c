package org.dronewatch.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.Settings;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

class DroneTest {
    private static final double TOLERANCE = 1e-12;
    private static final DroneSettings SETTINGS =
            DroneSettings.of(ModelSettings.of("none.obj"), new Hover(new Position(0, 0, 0), 0.0));

    private final Drone drone = new Drone(
            "drone", SETTINGS, KDTree.of(TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2
            })));

    @Test
    void itsSettingsCreateItAsThoseOfSensorsDo() {
        Settings<Drone> settings = DroneSettings.of(
                ModelSettings.packaged("quadrotor.obj"), new Hover(new Position(1, 2, 3), Math.PI / 2));
        Drone drone = settings.create();

        assertThat(drone.id()).isEqualTo("drone");
        assertThat(drone.settings()).isSameAs(settings);
        assertThat(drone.origin()).isEqualTo(new Position(1, 2, 3));
        assertThat(drone.tree().mesh().triangleCount()).isEqualTo(4904);
    }

    @Test
    void turnsAreRightHanded() {
        double quarter = Math.PI / 2;
        assertMaps(drone.rotateX(quarter, 1.0), new Point3d(0, 1, 0), new Point3d(0, 0, 1));
        assertMaps(drone.rotateY(quarter, 1.0), new Point3d(0, 0, 1), new Point3d(1, 0, 0));
        assertMaps(drone.rotateZ(quarter, 1.0), new Point3d(1, 0, 0), new Point3d(0, 1, 0));
    }

    @Test
    void theAngleIsRateTimesTime() {
        assertMaps(drone.rotateZ(Math.PI / 4, 2.0), new Point3d(1, 0, 0), new Point3d(0, 1, 0));
        assertMaps(drone.rotateZ(-Math.PI, 0.5), new Point3d(1, 0, 0), new Point3d(0, -1, 0));
    }

    /** A turn is about the drone's own axes, where it is: it moves neither the drone nor what turned before it. */
    @Test
    void aTurnAfterAMoveIsAboutTheDronesOwnOrigin() {
        Drone turned = drone.move(new Vector3d(10, 20, 30)).rotateZ(Math.PI / 2, 1.0);

        assertThat(turned.position()).isEqualTo(new Point3d(10, 20, 30));
        assertMaps(turned, new Point3d(1, 0, 0), new Point3d(10, 21, 30));
        assertMaps(turned.rotateX(Math.PI / 2, 1.0), new Point3d(0, 1, 0), new Point3d(10, 20, 31));
    }

    @Test
    void manySmallTurnsAreOneLargeOne() {
        Drone turning = drone;
        for (int i = 0; i < 1000; i++) {
            turning = turning.rotateX(0.3, 0.001).rotateX(0.7, 0.001);
        }
        Matrix4d expected = drone.rotateX(1.0, 1.0).modelMatrix();
        assertThat(turning.modelMatrix().epsilonEquals(expected, 1e-12)).isTrue();
    }

    @Test
    void aHeadingTurnsTheNoseClockwiseFromNorth() {
        FlightState east = new FlightState(new Position(5, 6, 7), new Position(3, 0, 0), Math.PI / 2);
        Drone flying = drone.at(east);

        assertMaps(flying, new Point3d(0, 1, 0), new Point3d(6, 6, 7));
        assertThat(flying.velocity()).isEqualTo(new Vector3d(3, 0, 0));
        assertThat(flying.distance(new Position(5, 6, 0))).isCloseTo(7.0, within(TOLERANCE));
    }

    @Test
    void pitchRaisesTheNoseAndRollLowersTheRightSide() {
        double third = Math.PI / 3;
        double half = Math.sqrt(3) / 2;
        assertMaps(at(0, third, 0), new Point3d(0, 1, 0), new Point3d(0, 0.5, half));
        assertMaps(at(0, third, 0), new Point3d(1, 0, 0), new Point3d(1, 0, 0));
        assertMaps(at(0, 0, third), new Point3d(1, 0, 0), new Point3d(0.5, 0, -half));
        assertMaps(at(0, 0, third), new Point3d(0, 1, 0), new Point3d(0, 1, 0));
        // Flying east with the nose up, the right side is to the south, and a roll turns about the raised nose.
        assertMaps(at(Math.PI / 2, third, 0), new Point3d(0, 1, 0), new Point3d(0.5, 0, half));
        assertMaps(at(Math.PI / 2, third, Math.PI / 2), new Point3d(1, 0, 0), new Point3d(half, 0, -0.5));
    }

    /** The three turns of the thesis, one after the other about the drone's own axes. */
    @Test
    void anAttitudeIsYawThenPitchThenRoll() {
        long seed = 20_231;
        System.out.println("seed of the attitudes: " + seed);
        Random random = new Random(seed);
        for (int i = 0; i < 1000; i++) {
            Attitude attitude = new Attitude(angle(random), angle(random), i % 7 == 0 ? 0.0 : angle(random));
            Drone flying = at(attitude.yaw(), attitude.pitch(), attitude.roll());
            Drone turned = drone.rotateZ(-attitude.yaw(), 1)
                    .rotateX(attitude.pitch(), 1)
                    .rotateY(attitude.roll(), 1);
            assertThat(flying.modelMatrix().epsilonEquals(turned.modelMatrix(), 1e-14))
                    .as("%s", attitude)
                    .isTrue();
            Position point = new Position(random.nextDouble(), random.nextDouble(), random.nextDouble());
            assertThat(attitude.toWorld(point).distance(flying.toWorld(point))).isLessThan(1e-14);
        }
    }

    @Test
    void aLevelDroneIsTurnedByItsYawAloneBitForBit() {
        Random random = new Random(20_232);
        for (int i = 0; i < 100; i++) {
            double yaw = angle(random);
            Matrix4d expected = new Matrix4d();
            expected.rotZ(-yaw);
            Matrix4d actual = at(yaw, 0, 0).modelMatrix();
            for (int row = 0; row < 4; row++) {
                for (int column = 0; column < 4; column++) {
                    assertThat(Double.doubleToRawLongBits(actual.getElement(row, column)))
                            .isEqualTo(Double.doubleToRawLongBits(expected.getElement(row, column)));
                }
            }
        }
    }

    @Test
    void anAttitudeIsFinite() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Attitude(0, Double.NaN, 0))
                .withMessage("pitch NaN must be a finite angle in rad");
    }

    private static double angle(Random random) {
        return random.nextDouble(-2 * Math.PI, 2 * Math.PI);
    }

    private Drone at(double yaw, double pitch, double roll) {
        Position origin = new Position(0, 0, 0);
        return drone.at(new FlightState(origin, origin, new Attitude(yaw, pitch, roll)));
    }

    @Test
    void theInverseLeadsBack() {
        Drone moved = drone.move(new Vector3d(1, 2, 3))
                .rotateX(0.3, 1)
                .rotateY(-1.1, 1)
                .rotateZ(2.0, 1);
        Matrix4d product = moved.worldToModel();
        product.mul(moved.modelMatrix());
        Matrix4d identity = new Matrix4d();
        identity.setIdentity();

        assertThat(product.epsilonEquals(identity, TOLERANCE)).isTrue();

        Point3d nose = new Point3d(0.3, 1.5, -0.2);
        moved.modelMatrix().transform(nose);
        Position inWorld = moved.toWorld(new Position(0.3, 1.5, -0.2));
        assertThat(inWorld).isEqualTo(Position.of(nose));
        assertThat(moved.toModel(inWorld).distance(new Position(0.3, 1.5, -0.2)))
                .isLessThan(TOLERANCE);
        assertThat(moved.toWorld(new Position(0, 0, 0))).isEqualTo(moved.origin());
        assertThat(moved.origin()).isEqualTo(Position.of(moved.position()));
    }

    @Test
    void whatACallerGetsDoesNotReachInside() {
        drone.modelMatrix().setZero();
        drone.worldToModel().setZero();
        drone.velocity().set(9, 9, 9);

        assertMaps(drone, new Point3d(1, 2, 3), new Point3d(1, 2, 3));
        assertThat(drone.velocity()).isEqualTo(new Vector3d());
    }

    @Test
    void aMatrixThatFlattensIsRefused() {
        Matrix4d flat = new Matrix4d();
        flat.setIdentity();
        flat.m22 = 0.0;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> drone.withModelMatrix(flat))
                .withMessageContaining("drone");
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SETTINGS.withSpeed(-1.0))
                .withMessageContaining("speed -1 m/s");
        assertThatIllegalArgumentException().isThrownBy(() -> SETTINGS.withSpeed(Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> SETTINGS.withRadarCrossSection(0.0));
        assertThatIllegalArgumentException().isThrownBy(() -> SETTINGS.withSoundLevel(500.0));
    }

    private static void assertMaps(Drone drone, Point3d model, Point3d world) {
        Point3d there = new Point3d(model);
        drone.modelMatrix().transform(there);
        assertThat(there.distance(world)).isCloseTo(0.0, within(TOLERANCE));
    }
}
