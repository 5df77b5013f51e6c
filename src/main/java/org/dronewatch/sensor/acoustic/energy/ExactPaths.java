package org.dronewatch.sensor.acoustic.energy;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.EnteredSolids;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.imagesource.WallTransmission;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The deterministic paths: the straight path from source to sensor, possibly through walls that transmit sound; the
 * paths around the edges of the obstacles that hide the source; and those of specular reflections. For use by one
 * thread.
 */
final class ExactPaths {
    private static final int BANDS = OctaveBands.COUNT;
    private static final double OWN = 1e-6;

    private final EnergyModel model;
    private final Air air;
    private final WallTransmission walls;
    private final EdgeLoss edges;
    private final SpecularPaths specular;
    private final GroundReflection ground;

    private final FoundPaths direct = new FoundPaths();
    private final FoundPaths diffracted = new FoundPaths();
    private final FoundPaths mirrored = new FoundPaths();
    private final double[] heard = new double[BANDS];

    /** Curvature of the sound from the source straight to the sensor, 1/m. */
    private double straightOn;

    /** Whether any sound arrives by the straight path. */
    private boolean isThrough;

    ExactPaths(EnergyModel model, World world, WallPlanes planes, BandSurfaces surfaces, Air air) {
        this.model = model;
        this.air = air;
        this.walls = new WallTransmission(world, planes, surfaces);
        this.edges = new EdgeLoss(model.diffraction(), world, surfaces, air);
        this.ground = new GroundReflection(model, world, surfaces, air);
        this.specular = new SpecularPaths(world, planes, surfaces, air, ground);
    }

    /**
     * Finds all paths from a source to a sensor.
     *
     * @param ofSensor image sources of the sensor
     * @param ofSource image sources of the source
     * @param first walls that rays from the ends hit first
     * @param extra walls that a path may hit besides those of an image source
     * @param curvature of the paths of sound
     */
    void find(
            SoundSource source,
            Position sensor,
            ImageSources ofSensor,
            ImageSources ofSource,
            int[] first,
            int[] extra,
            PathCurvature curvature) {
        direct.clear();
        diffracted.clear();
        mirrored.clear();
        Position position = source.position();
        Position vector = sensor.minus(position);
        straightOn = curvature.along(vector.x(), vector.y(), vector.z());
        isThrough = walls.trace(
                position.x(),
                position.y(),
                position.z(),
                sensor.x(),
                sensor.y(),
                sensor.z(),
                EnteredSolids.NONE,
                straightOn);
        ground.find(source, sensor, walls.isFree(), straightOn);
        if (isThrough) {
            addDirect(source, sensor);
        }
        if (!walls.isFree()) {
            addDiffracted(source, sensor);
        }
        specular.begin(source, sensor, curvature);
        specular.addTo(mirrored, ofSensor, ofSource);
        specular.addAlong(mirrored, first, model.imageSourceOrder());
        specular.addNeighbours(mirrored, extra, model.imageSourceOrder());
        ground.addTo(direct, mirrored, source, sensor);
    }

    /** The walls of all paths that several walls reflect, in order from the source on. */
    List<int[]> wallSequences() {
        return specular.found();
    }

    /** The sum over all exact paths in a band. */
    double heard(int band) {
        return direct.heard(band) + diffracted.heard(band) + mirrored.heard(band);
    }

    /** Sound by the straight path: the power spread over the sphere, reduced by air and walls. */
    FoundPaths direct() {
        return direct;
    }

    /** Sound diffracted around edges. */
    FoundPaths diffracted() {
        return diffracted;
    }

    /** Sound by specular reflections. */
    FoundPaths mirrored() {
        return mirrored;
    }

    private void addDirect(SoundSource source, Position sensor) {
        Position position = source.position();
        double length = Math.max(position.distance(sensor), OWN);
        double rise = (sensor.z() - position.z()) / length;
        boolean seen = walls.isFree() && !ground.interferes();
        if (seen) {
            edges.findNear(position, sensor, straightOn);
        }
        for (int band = 0; band < BANDS; band++) {
            double passed = seen ? edges.past(band) : walls.passed(band);
            heard[band] = passed * source.spread(air, band, rise, length);
        }
        direct.add(length, heard);
    }

    /** Whether the straight path leads through walls that transmit sound. */
    boolean isThroughWalls() {
        return isThrough && !walls.isFree();
    }

    /** The fraction that walls on the straight line transmit. */
    private double passed(int band) {
        return isThrough ? walls.passed(band) : 0.0;
    }

    /** The sound that would arrive directly in each band without obstructions. */
    double[] inTheOpen(SoundSource source, Position sensor) {
        double length = Math.max(source.position().distance(sensor), OWN);
        double rise = (sensor.z() - source.position().z()) / length;
        double[] open = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            open[band] = source.spread(air, band, rise, length);
        }
        return open;
    }

    private void addDiffracted(SoundSource source, Position sensor) {
        Position position = source.position();
        if (!edges.findPath(position, sensor, straightOn)) {
            return;
        }
        // Over a bulge of smooth ground that exists only for bent paths, sound runs along the ground together with its
        // reflection.
        double along = straightOn > 0.0 ? edges.ofSmoothGround() : 0.0;
        boolean isAlongGround =
                along > 0.0 && ground.findBelow(position, sensor, edges.path().halfWay());
        double straight = Math.max(position.distance(sensor), OWN);
        double length = straight + edges.path().pathDifference();
        boolean isGrazing = straightOn != 0.0 && edges.path().edges().count() == 0;
        if (isGrazing) {
            edges.findNear(position, sensor, straightOn);
        }
        for (int band = 0; band < BANDS; band++) {
            // The edges' loss is relative to what would arrive by the straight path. The air attenuates sound over the
            // longer path, and sound spreads over it if the detour is long. Transmitted energy is not available for
            // diffraction: both together never exceed the sound in the open.
            double left = isGrazing ? edges.past(band) : edges.round(band);
            if (isAlongGround) {
                left *= 1.0 + along * (ground.atGrazing(band, straight) - 1.0);
            }
            heard[band] = (1.0 - passed(band))
                    * Math.max(left, straightOn > 0.0 ? GroundReflection.DEEPEST : 0.0)
                    * source.fraction(band)
                    * source.factor(band, edges.path().sinElevation())
                    * air.left(band, length)
                    / (4.0 * Math.PI * straight * straight)
                    * EdgeLoss.overDetour(straight, length);
        }
        diffracted.add(length, heard);
    }
}
