package org.dronewatch.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.Ray;
import org.dronewatch.sensor.optics.CameraObject;
import org.jogamp.vecmath.Point2d;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

class ByHandTest {
    private static final double EXACT = 1e-9;

    /** 40 m in y, while z rises by a twentieth of that: distances are multiples of a vector longer than 1. */
    @Test
    void theTreeFindsWhatTryingEveryTriangleFinds() {
        Ray ray = new Ray(new Point3d(1, 0, 1.5), new Vector3d(0, 1, 0.05));
        assertEquals(40.0, ByHand.throughATree(ray).orElseThrow(), EXACT);
        assertEquals(40.0, ByHand.triangleByTriangle(ray).orElseThrow(), EXACT);

        Ray above = new Ray(new Point3d(1, 0, 1.5), new Vector3d(0, 1, 0.2));
        assertEquals(OptionalDouble.empty(), ByHand.throughATree(above));
        assertEquals(OptionalDouble.empty(), ByHand.triangleByTriangle(above));
        assertEquals(List.of(), ByHand.withinABox(above, ByHand.wall().bounds()));
    }

    @Test
    void aSphereIsMetWhereItsSurfaceIs() {
        Ray ray = new Ray(new Position(0, 0, 2), new Position(0, 1, 0));
        assertEquals(
                18.0,
                IntersectionHandler.raySphere(ray, new Point3d(0, 20, 2), 2.0).orElseThrow(),
                EXACT);
        assertEquals(List.of(40.0, 40.0), ByHand.withinABox(ray, ByHand.wall().bounds()));
    }

    /** A drone that has pitched up by half a radian points there, and shows more of itself. */
    @Test
    void aTurnedDroneShowsMorePixels() {
        Drone level = ByHand.turnedDrone(0.0);
        Drone pitched = ByHand.turnedDrone(0.25);
        Position nose = pitched.toWorld(new Position(0, 1, 0)).minus(pitched.origin());
        assertEquals(Math.cos(0.5), nose.y(), EXACT);
        assertEquals(Math.sin(0.5), nose.z(), EXACT);
        assertTrue(ByHand.pixels(pitched) > 1.2 * ByHand.pixels(level));
    }

    /**
     * The camera looks at the drone: it is in the middle of the image, and the ray of a pixel beside it leads past it.
     */
    @Test
    void aPointIsInTheImageWhereItsRayComesFrom() {
        CameraObject camera = ByHand.camera();
        Drone drone = ByHand.turnedDrone(0.0);
        Point2d pixel = camera.pixelOf(drone.position()).orElseThrow();
        assertEquals(0.5 * camera.width(), pixel.x, 1e-6);
        assertEquals(0.5 * camera.height(), pixel.y, 1e-6);

        // Half a pixel to the right of the axis and half a pixel below it.
        Ray ray = camera.ray(camera.width() / 2, camera.height() / 2);
        Position aside =
                Position.of(ray.direction()).times(1.0 / ray.direction().length());
        Position axis = drone.origin().minus(camera.position()).unit();
        double tangent = Math.tan(Math.acos(aside.dot(axis)));
        assertEquals(Math.sqrt(0.5) / camera.focalLength(), tangent, 1e-6);
    }

    /** Snell: concrete at 3400 m/s reflects everything beyond asin(343.2 / 3400) = 5.79 degrees. */
    @Test
    void soundIsReflectedAndRefracted() {
        double angle = Math.toRadians(5.0);
        List<Vector3d> directions = ByHand.soundAtTheWall(angle);
        assertEquals(2, directions.size());
        assertTrue(new Vector3d(Math.sin(angle), -Math.cos(angle), 0).epsilonEquals(directions.get(0), EXACT));
        assertEquals(Math.sin(angle) * 3400 / 343.2, directions.get(1).x, 1e-3);
        assertEquals(1, ByHand.soundAtTheWall(Math.toRadians(5.9)).size());
    }
}
