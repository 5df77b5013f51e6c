package org.dronewatch.sensor.acoustic.imagesource;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * Follows the rays of an {@link ImageSourceSearch} through the walls that they hit. From there on, they find image
 * sources whose paths pass through walls between reflections. For use by one thread.
 */
final class SearchThroughWalls {
    /** The maximum number of times that the rays of one direction pass through walls, in all branches together. */
    private static final int MOST_BRANCHES = 8;

    private final World world;
    private final Normals normals;
    private final RayTracer tracer;
    private final WallPlanes planes;
    private final BandSurfaces surfaces;
    private final CrossedFaces faces;
    private final double[] mirrored;
    private final double[] transmitted;
    private final AcousticRay ray = new AcousticRay();
    private final double[] normal = new double[3];
    private final Deque<Branch> branches = new ArrayDeque<>();

    private ImageSourceCandidates tree = new ImageSourceCandidates();
    private double least = 1.0;
    private int count;

    SearchThroughWalls(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.world = world;
        this.normals = new Normals(world.mesh());
        this.tracer = world.newIncoherentRayTracer();
        this.planes = planes;
        this.surfaces = surfaces;
        this.faces = new CrossedFaces(world, surfaces);
        this.mirrored = new double[world.surfaces().size()];
        this.transmitted = new double[mirrored.length];
        for (int material = 0; material < mirrored.length; material++) {
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                mirrored[material] += surfaces.mirrored(material, band) / OctaveBands.COUNT;
                transmitted[material] += surfaces.transmitted(material, band) / OctaveBands.COUNT;
            }
        }
    }

    /**
     * A ray that has passed through a wall.
     *
     * @param place three coordinates of the position at which it goes on, m, then three components of its direction
     * @param walls the walls that have reflected it so far
     * @param left the fraction of its energy that is left after these reflections
     * @param passed the fraction of this energy that is left after the walls through which it has passed
     * @param solids the solids that it is inside
     */
    private record Branch(double[] place, int[] walls, double left, double passed, EnteredSolids solids) {}

    /**
     * Prepares for a search.
     *
     * @param found receives the image sources; the worth of each is the fraction of a ray's energy that is left after
     *     reflections, reduced by walls only as far as they transmit less than {@code direct}
     * @param direct the fraction of direct sound that passes through walls, above 0: a ray is abandoned if its worth
     *     would be less than a thousandth
     */
    void start(ImageSourceCandidates found, double direct) {
        tree = found;
        least = direct;
    }

    /** Begins with a ray of another direction. */
    void begin() {
        count = 0;
        branches.clear();
    }

    /**
     * Sends a ray on through the wall that it has hit, if enough of it passes.
     *
     * @param hit the ray at the wall
     * @param triangle the triangle that it has hit
     * @param facing unit normal of the triangle, on the ray's side
     * @param walls the walls that have reflected the ray so far, as many as {@code order}
     * @param left the fraction of its energy that is left after these reflections
     */
    void pass(AcousticRay hit, int triangle, double[] facing, int[] walls, int order, double left) {
        int material = world.material(triangle, hit.originX, hit.originY);
        if (surfaces.transmits(material)) {
            faces.find(triangle, material, hit);
            branch(hit, facing, Arrays.copyOf(walls, order), left, 1.0, EnteredSolids.NONE);
        }
    }

    private void branch(
            AcousticRay hit, double[] facing, int[] walls, double left, double passed, EnteredSolids solids) {
        double through = passed;
        for (int i = 0; i < faces.count(); i++) {
            through *= faces.begins(i, solids) ? transmitted[faces.material(i)] : 1.0;
        }
        if (left * Math.min(1.0, through / least) < ImageSourceSearch.FAINT || count == MOST_BRANCHES) {
            return;
        }
        count++;
        EnteredSolids within = new EnteredSolids();
        within.copy(solids);
        faces.pass(within);
        double x = hit.originX;
        double y = hit.originY;
        double z = hit.originZ;
        hit.advance(faces.beyond());
        hit.standOff(facing, -1.0);
        double[] place = {hit.originX, hit.originY, hit.originZ, hit.directionX, hit.directionY, hit.directionZ};
        hit.originX = x;
        hit.originY = y;
        hit.originZ = z;
        branches.add(new Branch(place, walls, left, through, within));
    }

    /** Follows all rays that have passed through walls. */
    void follow(int maxOrder) {
        while (!branches.isEmpty()) {
            follow(branches.poll(), maxOrder);
        }
    }

    private void follow(Branch branch, int maxOrder) {
        ray.originX = branch.place[0];
        ray.originY = branch.place[1];
        ray.originZ = branch.place[2];
        ray.directionX = branch.place[3];
        ray.directionY = branch.place[4];
        ray.directionZ = branch.place[5];
        EnteredSolids solids = branch.solids;
        double left = branch.left;
        double passed = Math.min(1.0, branch.passed / least);
        int image = ImageSources.ORIGINAL;
        for (int wall : branch.walls) {
            image = tree.add(image, wall, left * passed);
        }
        int[] walls = Arrays.copyOf(branch.walls, maxOrder);
        int order = branch.walls.length;
        // A ray may leave several solids without being reflected.
        for (int met = 0; order < maxOrder && met < 2 * maxOrder && ray.meets(tracer); met++) {
            int triangle = tracer.triangle();
            normals.facing(triangle, ray, normal);
            ray.advance(tracer.distance());
            int material = world.material(triangle, ray.originX, ray.originY);
            if (surfaces.transmits(material)) {
                faces.find(triangle, material, ray);
                if (begun(solids) < 0) {
                    faces.pass(solids);
                    ray.advance(faces.beyond());
                    ray.standOff(normal, -1.0);
                    continue;
                }
                branch(ray, normal, Arrays.copyOf(walls, order), left, branch.passed, solids);
                material = faces.material(begun(solids));
            }
            left *= mirrored[material];
            int wall = planes.wallOf(triangle);
            if (left * passed < ImageSourceSearch.FAINT || wall == WallPlanes.NONE) {
                return;
            }
            walls[order++] = wall;
            image = tree.add(image, wall, left * passed);
            ray.standOff(normal, 1.0);
            ray.reflect(normal);
        }
    }

    /**
     * The first of the faces that were found through which the ray does not leave a solid; negative if there is none.
     */
    private int begun(EnteredSolids solids) {
        for (int i = 0; i < faces.count(); i++) {
            if (faces.begins(i, solids)) {
                return i;
            }
        }
        return -1;
    }
}
