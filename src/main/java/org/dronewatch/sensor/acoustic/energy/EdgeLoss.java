package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.edge.EdgePath;
import org.dronewatch.sensor.acoustic.edge.EdgeSequence;
import org.dronewatch.sensor.acoustic.edge.NearEdges;
import org.dronewatch.sensor.acoustic.edge.NearEdges.NearEdge;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Barrier;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The attenuation of sound between two points by the edges of obstacles: of sound diffracted around the edges if the
 * obstacles hide the source, and of direct sound that passes close to them.
 *
 * <p>An edge at which the outline bends by less than {@value #FULL_BEND} degrees counts in proportion to the bend; from
 * a Fresnel number N of {@value #FULL_SHADOW} on, in its shadow, it counts in full. So flat ground has no edges, and
 * ground with many slight bends attenuates little as long as it hides nothing. Several edges count as one until the
 * path bends by {@value #FULL_TURN} degrees at the first and at the last, so that an edge that the path just begins to
 * touch causes no step. Where another path is nearly as short as the shortest, such as one around two edges at the side
 * besides one over an edge at the top, the attenuation changes gradually from that of one path to that of the other.
 * For use by one thread.
 */
final class EdgeLoss {
    private static final int BANDS = OctaveBands.COUNT;

    /** Degrees by which the outline must bend for an edge to count in full at the shadow boundary. */
    private static final double FULL_BEND = 5.0;

    /** Fresnel number from which every edge counts in full. */
    private static final double FULL_SHADOW = 0.1;

    /** Degrees by which a path must bend at an edge for it to be the first or the last of several. */
    private static final double FULL_TURN = 0.5;

    /**
     * The fraction by which another path may be longer and still have an influence: less than the fraction up to which
     * {@link EdgePath} searches for others, so that no path appears or vanishes at once.
     */
    private static final double NEARLY_AS_SHORT = 0.1;

    /** The square root of 3. */
    private static final double SHORT_DETOUR = 1.7320508;

    /**
     * Up to this bend, in degrees, a surface counts as flat: coordinates of single precision are not exactly in a
     * plane.
     */
    private static final double FLAT = 0.1;

    private final Diffraction diffraction;
    private final BandSurfaces surfaces;
    private final Air air;
    private final EdgePath path;
    private final NearEdges near;
    private double difference;
    private final double[] losses = new double[BANDS];
    private final double[] past = new double[BANDS];

    EdgeLoss(Diffraction diffraction, World world, BandSurfaces surfaces, Air air) {
        this.diffraction = diffraction;
        this.surfaces = surfaces;
        this.air = air;
        this.path = new EdgePath(world);
        this.near = new NearEdges(world);
    }

    /**
     * Looks for the path around the obstacles that hide a source; returns false if there is none, or if there is no
     * diffraction.
     *
     * @param curvature curvature of sound from the source to the sensor, 1/m
     */
    boolean findPath(Position source, Position sensor, double curvature) {
        if (diffraction == Diffraction.OFF || !path.find(source, sensor, curvature)) {
            return false;
        }
        difference = curvature < 0.0 && diffraction.measuresArcs() ? path.arcDifference() : path.pathDifference();
        // If an arc just grazes the ground, the path needs no edge to go around it.
        double ofNone = curvature == 0.0 ? 1.0 : 0.0;
        double ofBend = path.edges().count() == 0 ? ofNone : weight(path.edges().bend());
        for (int band = 0; band < BANDS; band++) {
            double wavelength = wavelength(band);
            double depth = Barrier.fresnelNumber(difference, wavelength) / FULL_SHADOW;
            losses[band] = Math.min(1.0, ofBend + depth) * loss(wavelength);
        }
        return true;
    }

    /** The path found last. */
    EdgePath path() {
        return path;
    }

    /** The fraction of the energy that is diffracted around the edges of the path found last. */
    double round(int band) {
        return Math.pow(10.0, -0.1 * losses[band]);
    }

    /**
     * Looks for edges close to the line between two mutually visible points. If there are several, the one with the
     * greatest loss counts.
     *
     * @param curvature curvature of sound from the source to the sensor, 1/m
     */
    void findNear(Position source, Position sensor, double curvature) {
        Arrays.fill(past, 1.0);
        double farthest = diffraction.reach(wavelength(0));
        if (!(farthest > 0.0)) {
            return;
        }
        for (NearEdge edge : near.find(source, sensor, farthest, curvature)) {
            double weight = weight(edge.bend());
            for (int band = 0; band < BANDS; band++) {
                double loss = weight * diffraction.attenuation(-edge.detour(), 0.0, wavelength(band));
                double left = Math.pow(10.0, -0.1 * loss);
                // Of the energy that the edge removes, the obstacle transmits its fraction, as it does in its shadow.
                double through = surfaces.transmitted(edge.material(), band);
                past[band] = Math.min(past[band], left + (1.0 - left) * through);
            }
        }
    }

    /**
     * The fraction that is left of sound that spreads over a long detour. The methods of diffraction let sound spread
     * over the straight line, and limit the attenuation. This is appropriate for barriers, whose detours are short: up
     * to {@value #SHORT_DETOUR} times the straight line (20 lg of which is the 4.77 dB of the shadow boundary) nothing
     * is changed. Beyond that, sound spreads over the path, so that it is never louder than sound that has travelled as
     * far through open air.
     *
     * @param straight length of the straight line, above 0, m
     * @param path length of the path around the edges, m
     * @return 0 to 1
     */
    static double overDetour(double straight, double path) {
        double left = Math.min(1.0, SHORT_DETOUR * straight / path);
        return left * left;
    }

    /**
     * The degree to which the path found last leads over the bulge of smooth ground, rather than over edges, 0 to 1.
     */
    double ofSmoothGround() {
        return 1.0 - weight(path.edges().bend());
    }

    /** The fraction of the energy of direct sound that gets past the edges found last; 1 where none is near. */
    double past(int band) {
        return past[band];
    }

    /**
     * The attenuation by the edges of the shortest path, dB; if other paths are nearly as short, the mean over all of
     * these, in which longer paths have less weight.
     */
    private double loss(double wavelength) {
        double ofShortest = loss(path.edges(), wavelength);
        double more = 0.0;
        double weights = 1.0;
        for (int i = 0; i < path.others(); i++) {
            double longer = path.other(i).detour() / path.pathDifference() - 1.0;
            if (longer < NEARLY_AS_SHORT) {
                double weight = 1.0 - Math.max(0.0, longer) / NEARLY_AS_SHORT;
                more += weight * (loss(path.other(i), wavelength) - ofShortest);
                weights += weight;
            }
        }
        return ofShortest + more / weights;
    }

    /**
     * The attenuation by these edges, dB: of all pairs of a first and a last edge, the one with the greatest
     * attenuation counts.
     */
    private double loss(EdgeSequence edges, double wavelength) {
        double ofOne = diffraction.attenuation(difference, 0.0, wavelength);
        double most = ofOne;
        for (int last = edges.count() - 1; last > 0; last--) {
            double turnsLast = edges.turnFrom(last);
            for (int first = 0; first < last; first++) {
                double turnsFirst = edges.turnUpTo(first);
                double share = Math.min(1.0, Math.toDegrees(Math.min(turnsFirst, turnsLast)) / FULL_TURN);
                double span = edges.along(last) - edges.along(first);
                double ofSeveral = diffraction.attenuation(difference, span, wavelength);
                most = Math.max(most, ofOne + share * (ofSeveral - ofOne));
                if (Math.toDegrees(turnsFirst) >= FULL_TURN) {
                    break; // The edges after it are closer to the last.
                }
            }
            if (Math.toDegrees(turnsLast) >= FULL_TURN) {
                break; // The edges before it are closer to the first.
            }
        }
        return most;
    }

    private double wavelength(int band) {
        return air.soundSpeed() / OctaveBands.midband(band);
    }

    private static double weight(double bend) {
        return Math.max(0.0, Math.min(1.0, (Math.toDegrees(bend) - FLAT) / (FULL_BEND - FLAT)));
    }
}
