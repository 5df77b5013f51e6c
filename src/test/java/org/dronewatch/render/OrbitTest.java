package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.optics.CameraObject;
import org.jogamp.vecmath.Point2d;
import org.jogamp.vecmath.Point3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OrbitTest {
    private static final AABB BOX = new AABB(-20, 10, 3, 40, 190, 25);

    private static Point2d pixel(CameraObject camera, Position place) {
        return camera.pixelOf(place.toPoint3d()).orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1.0, 1.6, 2.4})
    void aPlanShowsAllOfABoxWithNorthUpAndEastToTheRight(double aspect) {
        Orbit orbit = Orbit.top(BOX, aspect);
        CameraObject camera = orbit.camera((int) (800 * aspect), 800);

        Point2d middle = pixel(camera, orbit.target());
        Point2d north = pixel(camera, orbit.target().plus(new Position(0, 10, 0)));
        Point2d east = pixel(camera, orbit.target().plus(new Position(10, 0, 0)));
        assertThat(middle.x).isCloseTo(400 * aspect, within(1.0));
        assertThat(middle.y).isCloseTo(400, within(1.0));
        assertThat(north.y).isLessThan(middle.y);
        assertThat(north.x).isCloseTo(middle.x, within(1e-3));
        assertThat(east.x).isGreaterThan(middle.x);
        // The scale bar's promise.
        assertThat((east.x - middle.x) * orbit.metresPerPixel(800)).isCloseTo(10.0, within(0.01));
        assertInside(camera, 0.0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1.0, 1.6, 2.4})
    void aSideViewIsLevelAndShowsAllOfABox(double aspect) {
        Orbit orbit = Orbit.side(BOX, aspect, Math.PI / 2);
        CameraObject camera = orbit.camera((int) (800 * aspect), 800);

        Point2d middle = pixel(camera, orbit.target());
        Point2d up = pixel(camera, orbit.target().plus(new Position(0, 0, 5)));
        // Seen from the east, north is to the right.
        Point2d north = pixel(camera, orbit.target().plus(new Position(0, 5, 0)));
        assertThat(up.y).isLessThan(middle.y);
        assertThat(up.x).isCloseTo(middle.x, within(1e-6));
        assertThat(north.x).isGreaterThan(middle.x);
        assertInside(camera, 0.0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 1.0, 1.6, 2.4})
    void anOrbitShowsNearlyAllOfABoxInPerspective(double aspect) {
        assertInside(Orbit.about(BOX, aspect).camera((int) (800 * aspect), 800), 40.0);
    }

    private static void assertInside(CameraObject camera, double margin) {
        for (Point3d corner : BOX.corners()) {
            Point2d at = camera.pixelOf(corner).orElseThrow();
            assertThat(at.x).isBetween(-margin, camera.width() + margin);
            assertThat(at.y).isBetween(-margin, camera.height() + margin);
        }
    }

    @Test
    void whatIsUnderThePointerMovesWithItWhenPanned() {
        Orbit orbit = new Orbit(new Position(3, 4, 5), 0.7, 0.4, 60, 0.6);
        double metres = orbit.metresPerPixel(500);
        Orbit panned = orbit.panned(-30 * metres, 20 * metres);

        Point2d before = pixel(orbit.camera(800, 500), orbit.target());
        Point2d after = pixel(panned.camera(800, 500), orbit.target());

        assertThat(after.x - before.x).isCloseTo(30, within(0.2));
        assertThat(after.y - before.y).isCloseTo(20, within(0.2));
    }

    @Test
    void walkingGoesWhereTheEyeLooksAndStaysLevel() {
        Orbit orbit = new Orbit(new Position(0, 0, 2), Math.PI, 0.3, 10, 0.6);

        Position ahead = orbit.walked(5, 0).eye().minus(orbit.eye());
        Position right = orbit.walked(0, 5).eye().minus(orbit.eye());

        // The eye stands in the south and looks north.
        assertThat(ahead.distance(new Position(0, 5, 0))).isLessThan(1e-9);
        assertThat(right.distance(new Position(5, 0, 0))).isLessThan(1e-9);
    }

    @Test
    void lookingAboutLeavesTheEyeWhereItIs() {
        Orbit orbit = new Orbit(new Position(1, 2, 3), 1.0, 0.2, 30, 0.6);
        Orbit turned = orbit.lookedAbout(0.4, 0.1);

        assertThat(turned.eye().distance(orbit.eye())).isLessThan(1e-9);
        assertThat(turned.target().distance(orbit.target())).isGreaterThan(5.0);
    }

    @Test
    void draggingToTheRightTurnsTheSiteToTheRight() {
        Orbit orbit = new Orbit(new Position(0, 0, 0), Math.PI, 0.3, 50, 0.6);
        Position nearSide = new Position(0, -10, 0);

        double before = pixel(orbit.camera(800, 500), nearSide).x;
        double after = pixel(orbit.turned(0.2, 0.0).camera(800, 500), nearSide).x;

        assertThat(after).isGreaterThan(before + 20);
    }
}
