package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The deterministic paths: straight from source to sensor, through walls that transmit sound; round the nearest edge of
 * what obstructs the source; and over specular reflections. Every triangle gives one first-order image source; its path
 * counts if it crosses that triangle and nothing obstructs its two legs. One per thread.
 */
final class ExactPaths {
    private static final int BANDS = OctaveBands.COUNT;
    private static final double OWN = 1e-6;

    private final EnergyModel model;
    private final TriangleMesh mesh;
    private final WallPlanes planes;
    private final Visibility visibility;
    private final BandSurfaces surfaces;
    private final Air air;
    private final WallTransmission walls;
    private final EdgePath edges;
    private final ImageSources imageSources;
    private final CoherentGround ground;

    private final FoundPaths direct = new FoundPaths();
    private final FoundPaths diffracted = new FoundPaths();
    private final FoundPaths mirrored = new FoundPaths();
    private final double[] heard = new double[BANDS];
    private Position[] mirrorPoints = new Position[16];
    private int mirrors;

    ExactPaths(EnergyModel model, World world, WallPlanes planes, BandSurfaces surfaces, Air air) {
        this.model = model;
        this.mesh = world.mesh();
        this.planes = planes;
        this.visibility = new Visibility(world);
        this.surfaces = surfaces;
        this.air = air;
        this.walls = new WallTransmission(world, surfaces);
        this.edges = new EdgePath(world);
        this.imageSources = new ImageSources(world, planes, surfaces, air, model.imageSourceOrder());
        this.ground = new CoherentGround(model, world, surfaces, air);
    }

    /** Finds all paths from a source to a sensor. */
    void find(SoundSource source, Position sensor) {
        direct.clear();
        diffracted.clear();
        mirrored.clear();
        mirrors = 0;
        addDirect(source, sensor);
        if (!walls.isFree()) {
            addDiffracted(source, sensor);
        }
        ground.find(source, sensor, walls.isFree());
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            addMirror(triangle, source, sensor);
        }
        imageSources.addTo(mirrored, source, sensor);
        ground.addTo(direct, mirrored, source, sensor);
    }

    /** What comes over all exact paths in all bands. */
    double heard() {
        return direct.heard() + diffracted.heard() + mirrored.heard();
    }

    /** What comes straight: power over the sphere, less air and walls. */
    FoundPaths direct() {
        return direct;
    }

    /** What comes round an edge. */
    FoundPaths diffracted() {
        return diffracted;
    }

    /** What arrives over specular reflections. */
    FoundPaths mirrored() {
        return mirrored;
    }

    private void addDirect(SoundSource source, Position sensor) {
        Position position = source.position();
        if (!walls.trace(
                position.x(), position.y(), position.z(), sensor.x(), sensor.y(), sensor.z(), AcousticRay.AIR)) {
            return;
        }
        double length = Math.max(position.distance(sensor), OWN);
        double rise = (sensor.z() - position.z()) / length;
        for (int band = 0; band < BANDS; band++) {
            heard[band] = walls.passed(band) * spread(source, band, rise, length);
        }
        direct.add(length, heard);
    }

    /** What would arrive directly in each band without obstructions. */
    double[] inTheOpen(SoundSource source, Position sensor) {
        double length = Math.max(source.position().distance(sensor), OWN);
        double rise = (sensor.z() - source.position().z()) / length;
        double[] open = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            open[band] = spread(source, band, rise, length);
        }
        return open;
    }

    /** Power in a band that leaves at an elevation, spread over the sphere after a distance. */
    private double spread(SoundSource source, int band, double rise, double length) {
        return source.spread(air, band, rise, length);
    }

    private void addDiffracted(SoundSource source, Position sensor) {
        Position position = source.position();
        if (!edges.find(position, sensor)) {
            return;
        }
        double straight = Math.max(position.distance(sensor), OWN);
        double length = straight + edges.pathDifference();
        for (int band = 0; band < BANDS; band++) {
            double wavelength = air.soundSpeed() / OctaveBands.midband(band);
            double loss = model.diffraction().attenuation(edges.pathDifference(), wavelength);
            // The edge's loss is relative to what would arrive by the straight path; only the air attenuates over the
            // longer one.
            heard[band] = Math.pow(10.0, -0.1 * loss)
                    * source.fraction(band)
                    * source.factor(band, edges.sinElevation())
                    * air.left(band, length)
                    / (4.0 * Math.PI * straight * straight);
        }
        diffracted.add(length, heard);
    }

    private void addMirror(int triangle, SoundSource source, Position sensor) {
        Position position = source.position();
        double ofSource = planes.height(triangle, position.x(), position.y(), position.z());
        double ofSensor = planes.height(triangle, sensor.x(), sensor.y(), sensor.z());
        int material = mesh.material(triangle);
        if (!(ofSource * ofSensor > 0.0) || !surfaces.mirrors(material)) {
            return;
        }
        // The straight line from the image source to the sensor crosses the plane here.
        double fraction = ofSource / (ofSource + ofSensor);
        double imageX = position.x() - 2.0 * ofSource * planes.normalX(triangle);
        double imageY = position.y() - 2.0 * ofSource * planes.normalY(triangle);
        double imageZ = position.z() - 2.0 * ofSource * planes.normalZ(triangle);
        double x = imageX + fraction * (sensor.x() - imageX);
        double y = imageY + fraction * (sensor.y() - imageY);
        double z = imageZ + fraction * (sensor.z() - imageZ);
        if (!isInside(triangle, x, y, z)) {
            return;
        }
        Position at = new Position(x, y, z);
        double length = new Position(imageX, imageY, imageZ).distance(sensor);
        if (isKnown(at, length) || !sees(position, at) || !sees(sensor, at)) {
            return;
        }
        remember(at);
        double rise = (z - position.z()) / at.distance(position);
        double cosine = Math.abs(ofSource + ofSensor) / length;
        for (int band = 0; band < BANDS; band++) {
            heard[band] = surfaces.mirrored(material, band, cosine) * spread(source, band, rise, length);
        }
        ground.among(mirrored, x, y, z).add(length, heard);
    }

    /** Whether a point of the triangle's plane lies in it, its border included. */
    private boolean isInside(int triangle, double x, double y, double z) {
        double nx = Math.abs(planes.normalX(triangle));
        double ny = Math.abs(planes.normalY(triangle));
        double nz = Math.abs(planes.normalZ(triangle));
        if (nx > ny) {
            return nx > nz ? isInside(triangle, 1, 2, y, z) : isInside(triangle, 0, 1, x, y);
        }
        return ny > nz ? isInside(triangle, 2, 0, z, x) : isInside(triangle, 0, 1, x, y);
    }

    private boolean isInside(int triangle, int u, int v, double atU, double atV) {
        boolean positive = false;
        boolean negative = false;
        for (int k = 0; k < 3; k++) {
            int next = k == 2 ? 0 : k + 1;
            double au = mesh.coordinate(triangle, k, u) - atU;
            double av = mesh.coordinate(triangle, k, v) - atV;
            double bu = mesh.coordinate(triangle, next, u) - atU;
            double bv = mesh.coordinate(triangle, next, v) - atV;
            double side = au * bv - av * bu;
            positive |= side > 0.0;
            negative |= side < 0.0;
        }
        return !(positive && negative);
    }

    /** A path over the common edge of two triangles of one wall is one path. */
    private boolean isKnown(Position at, double length) {
        for (int i = 0; i < mirrors; i++) {
            if (mirrorPoints[i].distance(at) < OWN * length) {
                return true;
            }
        }
        return false;
    }

    private void remember(Position at) {
        if (mirrors == mirrorPoints.length) {
            mirrorPoints = Arrays.copyOf(mirrorPoints, 2 * mirrors);
        }
        mirrorPoints[mirrors++] = at;
    }

    private boolean sees(Position from, Position surface) {
        return visibility.isFree(from, surface);
    }
}
