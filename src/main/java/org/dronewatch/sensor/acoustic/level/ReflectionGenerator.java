package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;

/**
 * Makes the rays that leave a surface: first the specular one, then one straight at the sensor if it lies on the same
 * side, the rest at random over the hemisphere; and, where the material lets sound through, one on the other side. One
 * per thread.
 */
final class ReflectionGenerator {
    /**
     * How far origins are moved off the surface, as a fraction of their coordinates: above rounding, negligible
     * otherwise.
     */
    private static final double STAND_OFF = 1e-9;

    private final TriangleMesh mesh;
    private final SurfaceLevels surfaces;
    private final Position sensor;
    private final AcousticRay branch = new AcousticRay();

    private final double[] normal = new double[3];

    /** The surface's normal on the side that the ray comes from. */
    private double normalX;

    private double normalY;
    private double normalZ;
    private double hitX;
    private double hitY;
    private double hitZ;

    ReflectionGenerator(TriangleMesh mesh, SurfaceLevels surfaces, Position sensor) {
        this.mesh = mesh;
        this.surfaces = surfaces;
        this.sensor = sensor;
    }

    /** Is given each branch of a hit; the carrier is reused. */
    interface Branches {
        void accept(AcousticRay branch);
    }

    /**
     * The branches of a ray that hits a triangle.
     *
     * @param ray the ray that arrives
     * @param distance from its origin to the triangle, m
     * @param arriving its level there, dB
     * @param count how many rays are reflected
     */
    void branch(
            AcousticRay ray,
            double distance,
            int triangle,
            double arriving,
            int count,
            RandomGenerator random,
            Branches target) {
        setHit(ray, distance, triangle);
        int material = mesh.material(triangle);
        branch.order = ray.order + 1;
        branch.travelled = ray.travelled + distance;

        branch.level = arriving - surfaces.reflectionLoss(material);
        branch.energy = ray.energy * surfaces.reflectedFraction(material) / count;
        branch.medium = ray.medium;
        standOff(1.0);
        reflectSpecular(ray);
        target.accept(branch);
        int made = 1;
        if (made < count && aimAtSensor()) {
            target.accept(branch);
            made++;
        }
        for (; made < count; made++) {
            drawOverHemisphere(random);
            target.accept(branch);
        }

        if (surfaces.transmits(material) && refract(ray, material)) {
            standOff(-1.0);
            boolean entering = ray.medium == AcousticRay.AIR;
            branch.level = arriving - (entering ? surfaces.transmissionLoss(material) : 0.0);
            branch.energy = ray.energy * surfaces.transmittedFraction(material);
            branch.medium = entering && !surfaces.isSheet(material) ? material : AcousticRay.AIR;
            target.accept(branch);
        }
    }

    private void setHit(AcousticRay ray, double distance, int triangle) {
        Normals.facing(mesh, triangle, ray, normal);
        normalX = normal[0];
        normalY = normal[1];
        normalZ = normal[2];
        hitX = ray.originX + distance * ray.directionX;
        hitY = ray.originY + distance * ray.directionY;
        hitZ = ray.originZ + distance * ray.directionZ;
    }

    /**
     * Puts the branch's origin a little before (1) or behind (-1) the surface, so that rounding cannot move it over.
     */
    private void standOff(double side) {
        double far = 1.0 + Math.abs(hitX) + Math.abs(hitY) + Math.abs(hitZ);
        double step = side * STAND_OFF * far;
        branch.originX = hitX + step * normalX;
        branch.originY = hitY + step * normalY;
        branch.originZ = hitZ + step * normalZ;
    }

    private void reflectSpecular(AcousticRay ray) {
        double twice = 2.0 * (ray.directionX * normalX + ray.directionY * normalY + ray.directionZ * normalZ);
        branch.directionX = ray.directionX - twice * normalX;
        branch.directionY = ray.directionY - twice * normalY;
        branch.directionZ = ray.directionZ - twice * normalZ;
    }

    private boolean aimAtSensor() {
        double x = sensor.x() - branch.originX;
        double y = sensor.y() - branch.originY;
        double z = sensor.z() - branch.originZ;
        if (x * normalX + y * normalY + z * normalZ <= 0.0) {
            return false;
        }
        double scale = 1.0 / Math.sqrt(x * x + y * y + z * z);
        branch.directionX = x * scale;
        branch.directionY = y * scale;
        branch.directionZ = z * scale;
        return true;
    }

    /** Uniform over the sphere, turned over to the surface's side. */
    private void drawOverHemisphere(RandomGenerator random) {
        Directions.draw(random, branch);
        double along = branch.directionX * normalX + branch.directionY * normalY + branch.directionZ * normalZ;
        if (along < 0.0) {
            branch.directionX = -branch.directionX;
            branch.directionY = -branch.directionY;
            branch.directionZ = -branch.directionZ;
        }
    }

    /**
     * The direction behind the surface by Snell's law, {@code sin t2 / sin t1 = c2 / c1}; a sheet keeps the direction.
     *
     * @return false for total internal reflection
     */
    private boolean refract(AcousticRay ray, int material) {
        double ratio = surfaces.isSheet(material)
                ? 1.0
                : surfaces.speedBehind(ray.medium, material) / surfaces.speed(ray.medium);
        double cos = -(ray.directionX * normalX + ray.directionY * normalY + ray.directionZ * normalZ);
        double sinSquared = ratio * ratio * (1.0 - cos * cos);
        if (sinSquared >= 1.0) {
            return false;
        }
        double normalPart = ratio * cos - Math.sqrt(1.0 - sinSquared);
        branch.directionX = ratio * ray.directionX + normalPart * normalX;
        branch.directionY = ratio * ray.directionY + normalPart * normalY;
        branch.directionZ = ratio * ray.directionZ + normalPart * normalZ;
        return true;
    }
}
