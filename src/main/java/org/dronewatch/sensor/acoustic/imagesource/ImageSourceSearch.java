package org.dronewatch.sensor.acoustic.imagesource;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * Finds the relevant image sources of a point: those whose walls reflect evenly spread rays from the point (M.
 * Vorlaender, JASA 86, 172, 1989). An image source whose walls subtend a smaller solid angle than that between
 * neighbouring rays may be missed. Searches from the same point give the same image sources. For use by one thread.
 */
public final class ImageSourceSearch {
    /** A ray is abandoned if less than this fraction of its energy is left after reflections. */
    static final double FAINT = 1e-3;

    /** The number of times that the search is refined around rays that alone have found an image source. */
    private static final int DEEPEST = 3;

    /** The number of rays that are sent around each of them. */
    private static final int AROUND = 8;

    /** Factor by which the spacing of rays shrinks each time: {@link #AROUND} rays share a disc. */
    private static final double FINER = 1.0 / Math.sqrt(AROUND);

    /** Image sources that keep less of a ray's energy than this are not refined. */
    private static final double WORTH_A_LOOK = 0.03;

    /** An image source found by no more than this number of rays is assumed to have neighbours that were missed. */
    private static final double FEW = 2.0;

    private final World world;
    private final Normals normals;
    private final RayTracer tracer;
    private final SearchThroughWalls beyond;
    private final boolean anyTransmits;
    private final WallPlanes planes;
    private final double[] mirrored;
    private final AcousticRay ray = new AcousticRay();

    /** The walls that have reflected the ray so far. */
    private int[] walls = new int[0];

    private final double[] normal = new double[3];

    /** A search among the planes of a world. */
    public ImageSourceSearch(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.world = world;
        this.normals = new Normals(world.mesh());
        this.tracer = world.newIncoherentRayTracer();
        this.beyond = new SearchThroughWalls(world, planes, surfaces);
        this.anyTransmits = surfaces.anyTransmits();
        this.planes = planes;
        this.mirrored = new double[world.surfaces().size()];
        for (int material = 0; material < mirrored.length; material++) {
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                mirrored[material] += surfaces.mirrored(material, band) / OctaveBands.COUNT;
            }
        }
    }

    /**
     * The image sources of a point. If few rays have found an image source of higher order, more rays are traced around
     * these.
     *
     * @param from the point, m
     * @param rays number of rays, spread over all directions
     * @param maxOrder maximum number of walls of an image source
     * @param behindWalls receives the image sources that rays find after they have passed through walls that transmit
     *     sound
     * @param direct the fraction of direct sound that passes through walls, above 0; a ray is abandoned when walls have
     *     transmitted only a much smaller fraction of its sound
     */
    public ImageSourceCandidates from(
            Position from, int rays, int maxOrder, ImageSourceCandidates behindWalls, double direct) {
        beyond.start(behindWalls, direct);
        ImageSourceCandidates tree = new ImageSourceCandidates();
        List<double[]> lonely = new ArrayList<>();
        for (int i = 0; i < rays; i++) {
            Directions.ofLattice(i, rays, ray);
            follow(tree, from, maxOrder, lonely);
        }
        // The approximate angle between neighbouring points of the lattice.
        double spacing = Math.sqrt(4.0 * Math.PI / rays);
        int left = rays;
        for (int depth = 0; depth < DEEPEST && !lonely.isEmpty(); depth++) {
            List<double[]> next = new ArrayList<>();
            for (int i = 0; i < lonely.size() && left > 0; i++) {
                for (int k = 0; k < AROUND; k++, left--) {
                    turn(lonely.get(i), spacing, k);
                    follow(tree, from, maxOrder, next);
                }
            }
            lonely = next;
            spacing *= FINER;
        }
        return tree;
    }

    /**
     * The image sources of a point that are found by rays towards some other points. Such image sources are those of
     * walls that enclose the other points and, seen from the point, subtend too small a solid angle to be found by rays
     * that are spread over all directions.
     *
     * @param from the point, m
     * @param to the other points, m
     * @param maxOrder maximum number of walls of an image source
     */
    public ImageSourceCandidates towards(Position from, List<Position> to, int maxOrder) {
        ImageSourceCandidates tree = new ImageSourceCandidates();
        beyond.start(new ImageSourceCandidates(), 1.0);
        for (Position point : to) {
            Position direction = point.minus(from);
            double length = direction.length();
            if (length > 0.0) {
                ray.directionX = direction.x() / length;
                ray.directionY = direction.y() / length;
                ray.directionZ = direction.z() / length;
                follow(tree, from, maxOrder, new ArrayList<>());
            }
        }
        return tree;
    }

    /**
     * Gives the ray one of several directions about a given one; they are spread evenly over a disc, like the seeds of
     * a sunflower.
     */
    private void turn(double[] about, double radius, int number) {
        double[] across = Math.abs(about[2]) < 0.9
                ? new double[] {about[1], -about[0], 0.0}
                : new double[] {0.0, about[2], -about[1]};
        double length = Math.sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
        double angle = Math.PI * (3.0 - Math.sqrt(5.0)) * number;
        double off = radius * Math.sqrt((number + 0.5) / AROUND);
        double u = off * Math.cos(angle) / length;
        double v = off * Math.sin(angle) / length;
        double x = about[0] + u * across[0] + v * (about[1] * across[2] - about[2] * across[1]);
        double y = about[1] + u * across[1] + v * (about[2] * across[0] - about[0] * across[2]);
        double z = about[2] + u * across[2] + v * (about[0] * across[1] - about[1] * across[0]);
        double whole = Math.sqrt(x * x + y * y + z * z);
        ray.directionX = x / whole;
        ray.directionY = y / whole;
        ray.directionZ = z / whole;
    }

    /**
     * Follows the ray in its direction, and keeps that direction if the ray has found an image source that few others
     * have found.
     */
    private void follow(ImageSourceCandidates tree, Position from, int maxOrder, List<double[]> lonely) {
        double[] direction = {ray.directionX, ray.directionY, ray.directionZ};
        ray.originX = from.x();
        ray.originY = from.y();
        ray.originZ = from.z();
        walls = walls.length < maxOrder ? new int[maxOrder] : walls;
        int image = ImageSources.ORIGINAL;
        double left = 1.0;
        boolean isLonely = false;
        if (anyTransmits) {
            beyond.begin();
        }
        for (int order = 0; order < maxOrder; order++) {
            if (!ray.meets(tracer)) {
                break;
            }
            int triangle = tracer.triangle();
            normals.facing(triangle, ray, normal);
            ray.advance(tracer.distance());
            if (anyTransmits) {
                beyond.pass(ray, triangle, normal, walls, order, left);
            }
            left *= mirrored[world.material(triangle, ray.originX, ray.originY)];
            if (left < FAINT) {
                break;
            }
            ray.standOff(normal, 1.0);
            ray.reflect(normal);
            walls[order] = planes.wallOf(triangle);
            image = tree.add(image, walls[order], left);
            isLonely |= order > 0 && left > WORTH_A_LOOK && tree.worth(image) <= FEW * left;
        }
        if (anyTransmits) {
            beyond.follow(maxOrder);
        }
        if (isLonely) {
            lonely.add(direction);
        }
    }
}
