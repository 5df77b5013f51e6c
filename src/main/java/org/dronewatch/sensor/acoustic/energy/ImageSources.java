package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Paths over two or more specular reflections in the largest walls, exact: the source is mirrored from wall to wall,
 * and the path back from the sensor must meet every wall where it should, with nothing between (Allen and Berkley, JASA
 * 65, 1979; Borish, JASA 75, 1984, for rooms of any shape). One per thread.
 */
final class ImageSources {
    private static final int BANDS = OctaveBands.COUNT;

    /** A point so near to a plane is on it, m: at the edge of two walls a path meets both at once. */
    private static final double ON = 1e-6;

    private final TriangleMesh mesh;
    private final WallPlanes planes;
    private final Visibility visibility;
    private final BandSurfaces surfaces;
    private final Air air;
    private final int maxOrder;
    private final int[] walls;
    private final int[] materials;
    private final double[] cosines;
    private final double[][] images;
    private final double[] heard = new double[BANDS];
    private double[] heardImages = new double[3 * 16];
    private int heardCount;

    ImageSources(World world, WallPlanes planes, BandSurfaces surfaces, Air air, int maxOrder) {
        this.mesh = world.mesh();
        this.planes = planes;
        this.visibility = new Visibility(world);
        this.surfaces = surfaces;
        this.air = air;
        this.maxOrder = maxOrder;
        this.walls = new int[maxOrder];
        this.materials = new int[maxOrder];
        this.cosines = new double[maxOrder];
        this.images = new double[maxOrder + 1][3];
    }

    /** Adds all paths of order two to the largest one. */
    void addTo(FoundPaths paths, SoundSource source, Position sensor) {
        Position position = source.position();
        images[0][0] = position.x();
        images[0][1] = position.y();
        images[0][2] = position.z();
        heardCount = 0;
        mirror(0, source, sensor, paths);
    }

    /** Mirrors the last image in every wall but the one before; looks for a path from two reflections on. */
    private void mirror(int order, SoundSource source, Position sensor, FoundPaths paths) {
        for (int wall = 0; wall < planes.wallCount(); wall++) {
            if (order > 0 && walls[order - 1] == wall) {
                continue;
            }
            int triangle = planes.triangleOf(wall);
            double[] from = images[order];
            double[] to = images[order + 1];
            double twice = 2.0 * planes.height(triangle, from[0], from[1], from[2]);
            to[0] = from[0] - twice * planes.normalX(triangle);
            to[1] = from[1] - twice * planes.normalY(triangle);
            to[2] = from[2] - twice * planes.normalZ(triangle);
            walls[order] = wall;
            if (order > 0) {
                follow(order, source, sensor, paths);
            }
            if (order + 1 < maxOrder) {
                mirror(order + 1, source, sensor, paths);
            }
        }
    }

    /** Follows a path back from the sensor over the walls of the last images, and adds it if it gets to the source. */
    private void follow(int last, SoundSource source, Position sensor, FoundPaths paths) {
        double x = sensor.x();
        double y = sensor.y();
        double z = sensor.z();
        int wall = WallPlanes.NONE;
        for (int k = last; k >= 0; k--) {
            int triangle = planes.triangleOf(walls[k]);
            double[] image = images[k + 1];
            double here = planes.height(triangle, x, y, z);
            double there = planes.height(triangle, image[0], image[1], image[2]);
            cosines[k] = Math.abs(here - there)
                    / Math.sqrt(square(image[0] - x) + square(image[1] - y) + square(image[2] - z));
            if (k < last && Math.abs(here) < ON && planes.mayContain(walls[k], x, y, z)) {
                materials[k] = mesh.material(triangle);
                continue;
            }
            if (!(here * there < 0.0)) {
                return;
            }
            double fraction = here / (here - there);
            double dx = fraction * (image[0] - x);
            double dy = fraction * (image[1] - y);
            double dz = fraction * (image[2] - z);
            if (!planes.mayContain(walls[k], x + dx, y + dy, z + dz)
                    || !findFirst(x, y, z, dx, dy, dz, Double.POSITIVE_INFINITY, wall)
                    || planes.wallOf(visibility.triangle()) != walls[k]) {
                return;
            }
            materials[k] = mesh.material(visibility.triangle());
            x += dx;
            y += dy;
            z += dz;
            wall = walls[k];
        }
        double[] position = images[0];
        if (findFirst(x, y, z, position[0] - x, position[1] - y, position[2] - z, 1.0, wall)) {
            return;
        }
        double[] image = images[last + 1];
        if (!addUnlessKnown(image)) {
            return;
        }
        double length = new Position(image[0], image[1], image[2]).distance(sensor);
        double firstLeg = Math.sqrt(square(x - position[0]) + square(y - position[1]) + square(z - position[2]));
        double rise = (z - position[2]) / firstLeg;
        for (int band = 0; band < BANDS; band++) {
            heard[band] = source.fraction(band)
                    * source.factor(band, rise)
                    * air.left(band, length)
                    / (4.0 * Math.PI * length * length);
            for (int k = 0; k <= last; k++) {
                heard[band] *= surfaces.mirrored(materials[k], band, cosines[k]);
            }
        }
        paths.add(length, heard);
    }

    /**
     * Finds what a leg of a path hits first. The wall that it comes from is flat and hides nothing of what lies
     * before it, though rounding may have put the leg's beginning behind one of its triangles.
     *
     * @param end which multiple of the leg's vector leads to its end; infinite where it ends at the next wall
     * @param wall where the leg begins, or {@link WallPlanes#NONE}
     */
    private boolean findFirst(double x, double y, double z, double dx, double dy, double dz, double end, int wall) {
        boolean found = visibility.findFirstAlong(x, y, z, dx, dy, dz, end);
        while (found && wall != WallPlanes.NONE && planes.wallOf(visibility.triangle()) == wall) {
            found = visibility.findNext();
        }
        return found;
    }

    /**
     * Over the edge of two walls at a right angle, both orders of the walls give the same path.
     *
     * @return whether the image was new
     */
    private boolean addUnlessKnown(double[] image) {
        for (int i = 0; i < heardCount; i++) {
            double away = Math.abs(heardImages[3 * i] - image[0])
                    + Math.abs(heardImages[3 * i + 1] - image[1])
                    + Math.abs(heardImages[3 * i + 2] - image[2]);
            if (away < ON) {
                return false;
            }
        }
        if (3 * heardCount == heardImages.length) {
            heardImages = Arrays.copyOf(heardImages, 2 * heardImages.length);
        }
        System.arraycopy(image, 0, heardImages, 3 * heardCount, 3);
        heardCount++;
        return true;
    }

    private static double square(double value) {
        return value * value;
    }
}
