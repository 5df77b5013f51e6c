package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.world.World;

/**
 * Generates the rays from a surface: first the specular one, then one straight to the sensor if the sensor lies on the
 * same side of the surface, and the rest at random over the hemisphere; if the material transmits sound, also rays on
 * the other side, the first refracted and the rest scattered. It follows sections 5.2.3 and 6.2.11 of the thesis on
 * which this project is based. For use by one thread.
 */
public final class ReflectionGenerator {
    /**
     * The distance by which origins are moved off the surface, as a fraction of their coordinates: above rounding
     * errors, and otherwise negligible.
     */
    private static final double STAND_OFF = 1e-9;

    private final LevelModel model;
    private final World world;
    private final Normals normals;
    private final SurfaceLevels surfaces;
    private final Position sensor;
    private final ScatteredRays scattered;
    private final AcousticRay branch = new AcousticRay();

    private final double[] normal = new double[3];

    /** The x component of the surface's normal on the side from which the ray comes. */
    private double normalX;

    private double normalY;
    private double normalZ;
    private double hitX;
    private double hitY;
    private double hitZ;

    /**
     * A generator for the surfaces of a world.
     *
     * @param model number of rays from a surface, and division of the energy among them
     * @param sensor position at which the second ray is aimed, m
     */
    public ReflectionGenerator(LevelModel model, World world, Position sensor) {
        this(model, world, new SurfaceLevels(world), sensor, 0.0);
    }

    /** A generator for a sensor at which rays within a radius are directed, m. */
    ReflectionGenerator(LevelModel model, World world, SurfaceLevels surfaces, Position sensor, double radius) {
        this.model = model;
        this.world = world;
        this.normals = new Normals(world.mesh());
        this.surfaces = surfaces;
        this.sensor = sensor;
        this.scattered = new ScatteredRays(sensor, radius);
    }

    /** Receives each ray from a hit. */
    @FunctionalInterface
    public interface Branches {
        /**
         * Receives a ray.
         *
         * @param branch the ray; the object is reused, so copy data to be kept
         */
        void accept(AcousticRay branch);
    }

    /**
     * Generates the rays from a triangle that a ray hits. Every reflected ray has the level of the arriving ray minus
     * the loss of the reflection, and every transmitted ray has the level of the arriving ray minus the loss on
     * entering the wall; the reflected energy is divided among the reflected rays, and the transmitted energy among the
     * transmitted ones.
     *
     * @param ray the ray that arrives
     * @param distance distance from the ray's origin to the triangle, m
     * @param triangle index of the triangle in the world's mesh
     * @param arriving level of the ray at the triangle, dB on the calibrated scale of the level model
     * @param random draws the directions of scattered rays
     * @param target receives the rays, the specular one first
     */
    public void acousticDistribution(
            AcousticRay ray, double distance, int triangle, double arriving, RandomGenerator random, Branches target) {
        Draw draw = new Draw(random, target, branch -> ScatteredRays.Wanted.ALL);
        acousticDistribution(ray, distance, triangle, arriving, draw);
    }

    /**
     * The random numbers, the receiver and the choice with which rays are drawn.
     *
     * @param random draws the directions of scattered rays
     * @param target receives the rays
     * @param wanted which scattered rays it receives; the random numbers of the others are skipped
     */
    record Draw(RandomGenerator random, Branches target, ScatteredRays.Choice wanted) {}

    /** Generates the rays from a triangle that a ray hits, but only those scattered rays that are wanted. */
    void acousticDistribution(AcousticRay ray, double distance, int triangle, double arriving, Draw draw) {
        setHit(ray, distance, triangle);
        int material = world.material(triangle, hitX, hitY);
        branch.order = ray.order + 1;
        branch.travelled = ray.travelled + distance;
        reflect(ray, material, arriving, draw);
        if (surfaces.transmits(material) && refract(ray, material)) {
            transmit(ray, material, arriving, draw);
        }
    }

    private void reflect(AcousticRay ray, int material, double arriving, Draw draw) {
        int count = model.reflectionsPerHit();
        double cosine = -(ray.directionX * normalX + ray.directionY * normalY + ray.directionZ * normalZ);
        double reflected = ray.energy * surfaces.reflectedFraction(material, cosine);
        branch.level = arriving - surfaces.reflectionLoss(material, cosine);
        branch.medium = ray.medium;
        standOff(1.0);
        reflectSpecular(ray);
        branch.energy = ofStraightRay(reflected, count);
        draw.target.accept(branch);
        branch.energy = ofScatteredRay(reflected, count);
        int made = 1;
        if (made < count && aimAtSensor()) {
            draw.target.accept(branch);
            made++;
        }
        scatter(count - made, 1.0, draw);
    }

    /** Generates the rays on the far side; the branch is already the first of them, the refracted one. */
    private void transmit(AcousticRay ray, int material, double arriving, Draw draw) {
        int count = model.transmittedRays();
        double transmitted = ray.energy * surfaces.transmittedFraction(material);
        boolean entering = ray.medium == AcousticRay.AIR;
        standOff(-1.0);
        branch.level = arriving - (entering ? surfaces.transmissionLoss(material) : 0.0);
        branch.medium = entering && !surfaces.isSheet(material) ? material : AcousticRay.AIR;
        branch.energy = ofStraightRay(transmitted, count);
        draw.target.accept(branch);
        branch.energy = ofScatteredRay(transmitted, count);
        scatter(count - 1, -1.0, draw);
    }

    private void scatter(int count, double side, Draw draw) {
        scattered.draw(branch, count, normal, side, draw.random, draw.wanted.of(branch), draw.target);
    }

    /**
     * The energy of the specular or the refracted ray, given that of all rays on its side; all of it if it is the only
     * one.
     */
    private double ofStraightRay(double energy, int count) {
        return count == 1 || model.diffraction().isEmpty()
                ? energy / count
                : energy * (1.0 - model.diffraction().get());
    }

    /** The energy of each other ray. */
    private double ofScatteredRay(double energy, int count) {
        return model.diffraction().isEmpty()
                ? energy / count
                : energy * model.diffraction().get() / (count - 1);
    }

    private void setHit(AcousticRay ray, double distance, int triangle) {
        normals.facing(triangle, ray, normal);
        normalX = normal[0];
        normalY = normal[1];
        normalZ = normal[2];
        hitX = ray.originX + distance * ray.directionX;
        hitY = ray.originY + distance * ray.directionY;
        hitZ = ray.originZ + distance * ray.directionZ;
    }

    /**
     * Puts the branch's origin a little in front of the surface (1) or behind it (-1), so that rounding cannot move it
     * to the other side.
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

    /**
     * Sets the direction of the branch behind the surface by Snell's law, {@code sin t2 / sin t1 = c2 / c1}; a sheet
     * keeps the direction.
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
