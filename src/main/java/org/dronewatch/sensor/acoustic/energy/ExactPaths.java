package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The paths that need no chance: straight from source to sensor, through what lets sound pass, and over one mirror
 * reflection. A triangle mirrors the source; the path counts when it crosses that triangle and nothing stands in its two
 * legs.
 */
final class ExactPaths {
    private static final int BANDS = OctaveBands.COUNT;
    private static final double OWN = 1e-6;

    private final TriangleMesh mesh;
    private final KDTraversal traversal;
    private final BandSurfaces surfaces;
    private final double[] airLoss;
    private final double[] passed = new double[BANDS];
    private final AcousticRay ray = new AcousticRay();
    private final double[] normal = new double[3];

    private double[] mirrorWays = new double[16];
    private double[] mirrorHeard = new double[16];
    private Position[] mirrorPlaces = new Position[16];
    private int mirrors;

    ExactPaths(World world, BandSurfaces surfaces, double[] airLoss) {
        this.mesh = world.mesh();
        this.traversal = world.newTraversal();
        this.surfaces = surfaces;
        this.airLoss = airLoss;
    }

    /** Is given each mirror path of the last question: its length in metres and what is heard by it in all bands. */
    interface Mirrors {
        void accept(double way, double heard);
    }

    void forEachMirror(Mirrors target) {
        for (int i = 0; i < mirrors; i++) {
            target.accept(mirrorWays[i], mirrorHeard[i]);
        }
    }

    /** What is heard straight from the source, by band: power over the sphere, less air and walls. */
    double[] direct(Position source, Position sensor, double[] power) {
        double[] heard = new double[BANDS];
        if (passes(source, sensor)) {
            double way = Math.max(source.distance(sensor), OWN);
            for (int band = 0; band < BANDS; band++) {
                heard[band] = passed[band] * spread(power[band], way, band);
            }
        }
        return heard;
    }

    private double spread(double power, double way, int band) {
        return power * Math.exp(-airLoss[band] * way) / (4.0 * Math.PI * way * way);
    }

    /** What is heard over single mirror reflections, by band. */
    double[] mirrored(Position source, Position sensor, double[] power) {
        double[] heard = new double[BANDS];
        mirrors = 0;
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            addMirror(triangle, source, sensor, power, heard);
        }
        return heard;
    }

    private void addMirror(int triangle, Position source, Position sensor, double[] power, double[] heard) {
        // A ray of no direction: any side of the triangle will do.
        ray.directionX = 0.0;
        ray.directionY = 0.0;
        ray.directionZ = 0.0;
        Normals.facing(mesh, triangle, ray, normal);
        double plane = normal[0] * mesh.coordinate(triangle, 0, 0)
                + normal[1] * mesh.coordinate(triangle, 0, 1)
                + normal[2] * mesh.coordinate(triangle, 0, 2);
        double ofSource = height(source, plane);
        double ofSensor = height(sensor, plane);
        if (!(ofSource * ofSensor > 0.0)) {
            return;
        }
        // The straight way from the mirror image to the sensor crosses the plane here.
        double share = ofSource / (ofSource + ofSensor);
        Position image = source.minus(new Position(normal[0], normal[1], normal[2]).times(2.0 * ofSource));
        Position at = image.plus(sensor.minus(image).times(share));
        if (!isInside(triangle, at)) {
            return;
        }
        double way = image.distance(sensor);
        if (isKnown(at, way) || !sees(source, at) || !sees(sensor, at)) {
            return;
        }
        int material = mesh.material(triangle);
        double all = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double reflected = surfaces.reflected(material, band) * (1.0 - surfaces.scattered(material, band));
            double level = reflected * spread(power[band], way, band);
            heard[band] += level;
            all += level;
        }
        remember(at, way, all);
    }

    private double height(Position place, double plane) {
        return normal[0] * place.x() + normal[1] * place.y() + normal[2] * place.z() - plane;
    }

    /** Whether a point of the triangle's plane lies in it, its border included. */
    private boolean isInside(int triangle, Position p) {
        int axis = Math.abs(normal[0]) > Math.abs(normal[1])
                ? (Math.abs(normal[0]) > Math.abs(normal[2]) ? 0 : 2)
                : (Math.abs(normal[1]) > Math.abs(normal[2]) ? 1 : 2);
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        double[] place = {p.x(), p.y(), p.z()};
        boolean positive = false;
        boolean negative = false;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            double au = mesh.coordinate(triangle, k, u) - place[u];
            double av = mesh.coordinate(triangle, k, v) - place[v];
            double bu = mesh.coordinate(triangle, next, u) - place[u];
            double bv = mesh.coordinate(triangle, next, v) - place[v];
            double side = au * bv - av * bu;
            positive |= side > 0.0;
            negative |= side < 0.0;
        }
        return !(positive && negative);
    }

    /** A path over the common edge of two triangles of one wall is one path. */
    private boolean isKnown(Position at, double way) {
        for (int i = 0; i < mirrors; i++) {
            if (mirrorPlaces[i].distance(at) < OWN * way) {
                return true;
            }
        }
        return false;
    }

    private void remember(Position at, double way, double heard) {
        if (mirrors == mirrorWays.length) {
            mirrorWays = Arrays.copyOf(mirrorWays, 2 * mirrors);
            mirrorHeard = Arrays.copyOf(mirrorHeard, 2 * mirrors);
            mirrorPlaces = Arrays.copyOf(mirrorPlaces, 2 * mirrors);
        }
        mirrorWays[mirrors] = way;
        mirrorHeard[mirrors] = heard;
        mirrorPlaces[mirrors] = at;
        mirrors++;
    }

    private boolean sees(Position from, Position surface) {
        Position way = surface.minus(from);
        return !traversal.isOccluded(from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), 0.0, 1.0 - OWN);
    }

    /** Follows the straight way through all that stands in it; false where something lets nothing pass. */
    private boolean passes(Position from, Position to) {
        Arrays.fill(passed, 1.0);
        Position way = to.minus(from);
        double start = 0.0;
        int medium = AcousticRay.AIR;
        while (traversal.closestHit(from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), start, 1.0 - 1e-9)) {
            int material = mesh.material(traversal.triangle());
            if (!surfaces.transmits(material)) {
                return false;
            }
            if (medium == material) {
                medium = AcousticRay.AIR;
            } else {
                for (int band = 0; band < BANDS; band++) {
                    passed[band] *= surfaces.transmitted(material, band);
                }
                medium = surfaces.isSheet(material) ? medium : material;
            }
            start = traversal.distance() + 1e-9;
        }
        return true;
    }
}
