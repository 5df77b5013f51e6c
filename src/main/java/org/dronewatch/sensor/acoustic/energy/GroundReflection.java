package org.dronewatch.sensor.acoustic.energy;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.GroundPlane;
import org.dronewatch.sound.Barrier;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.GroundImpedance;
import org.dronewatch.sound.surface.GroundInterference;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceRoughness;
import org.dronewatch.sound.surface.TurbulentCoherence;
import org.dronewatch.world.World;

/**
 * The reflection of direct sound by the ground below it. If the model says so, the direct sound and this reflection
 * interfere, unless walls dominate: if other reflections carry more energy than these two together, all phases are
 * taken as random, including that of the ground reflection. This reflection takes the place of the first-order
 * reflections within the ground's Fresnel zone. If the air bends the paths, those reflections come from here even if
 * they do not interfere, since the straight paths meet the ground elsewhere. Rough ground then scatters as much of them
 * as in still air, even at grazing incidence, so that the slightest gradient changes nothing. Sound scattered by rough
 * ground is left to the rays. For use by one thread.
 */
final class GroundReflection {
    private static final int BANDS = OctaveBands.COUNT;

    /** The frequency for which the Fresnel zone is computed, in the middle of a drone's spectrum, Hz. */
    private static final double ZONE_FREQUENCY = 500.0;

    /**
     * The least fraction of the free field that is left of sound that bends up: turbulence scatters as much sound into
     * the deepest shadow as into the deepest interference at its border, so that neither is deeper than
     * {@value Barrier#LIMIT} dB.
     */
    static final double DEEPEST = Levels.toRatio(-Barrier.LIMIT);

    /**
     * Where sound bends up, the direct and the reflected ray come closer and closer to each other towards the border of
     * the shadow, and coincide there. Turbulence, which makes rays wander, still keeps them apart: their distance is
     * taken to be at least this fraction of the distance at which they would pass each other in still air, and the
     * heights of both ends above the ground are taken to be no less than this implies. From the parabolic equation in
     * turbulent air, which gives 0.16 to 0.21 in five cases of heights, gradient and frequency (BorderSeparationTest).
     */
    private static final double LEAST_SEPARATION = 0.19;

    private final boolean isCoherent;
    private final GroundPlane plane;
    private final List<SurfaceMaterial> materials;
    private final BandSurfaces surfaces;
    private final Air air;
    private final TurbulentCoherence turbulence;
    private final FoundPaths replaced = new FoundPaths();
    private final double[] both = new double[BANDS];
    private boolean isFound;

    /** Whether sound travels along the ground found last, in the shadow behind its bulge. */
    private boolean isAlong;

    private boolean bendsUp;

    GroundReflection(EnergyModel model, World world, BandSurfaces surfaces, Air air) {
        this.isCoherent = model.ground() == EnergyModel.Ground.COHERENT;
        this.plane = new GroundPlane(world);
        this.materials = world.surfaces();
        this.surfaces = surfaces;
        this.air = air;
        this.turbulence = new TurbulentCoherence(model.turbulence(), model.turbulenceScale());
    }

    /**
     * Searches for the ground between a source and a sensor.
     *
     * @param isFree whether there is a line of sight; without direct sound there is nothing for the ground reflection
     *     to interfere with
     * @param curvature curvature of sound from the source to the sensor, 1/m
     */
    void find(SoundSource source, Position sensor, boolean isFree, double curvature) {
        replaced.clear();
        bendsUp = curvature > 0.0;
        isAlong = false;
        isFound = (isCoherent || curvature != 0.0)
                && isFree
                && plane.find(source.position(), sensor, air.soundSpeed() / ZONE_FREQUENCY, curvature);
    }

    /**
     * Whether there is ground whose reflection interferes: the bumps of the ground are then part of the reflection, not
     * edges.
     */
    boolean interferes() {
        return isFound && isCoherent;
    }

    /**
     * Searches for the ground along which sound travels in the shadow behind a bulge.
     *
     * @param along distance from the source along the straight line, m
     * @return whether there is any
     */
    boolean findBelow(Position source, Position sensor, double along) {
        isAlong = plane.findHighest(source, sensor, along / source.distance(sensor), air.soundSpeed() / ZONE_FREQUENCY);
        return isAlong;
    }

    /**
     * The sound that grazes the ground found last, as a multiple of the sound that arrives directly: 4 for hard ground
     * with interference, 2 without.
     *
     * @param length length of the path, m
     */
    double atGrazing(int band, double length) {
        int material = plane.material();
        GroundImpedance impedance = materials.get(material).groundImpedance().orElse(null);
        double reflected = reflected(material, impedance, band, 0.0);
        if (!isCoherent) {
            return 1.0 + reflected;
        }
        GroundImpedance ground = impedance == null ? GroundImpedance.RIGID : impedance;
        // Rays that graze the ground leave and arrive at the same angle, and the distances are in proportion to the
        // square roots of the heights.
        double source = Math.sqrt(Math.max(0.0, plane.firstOverGround()));
        double sensor = Math.sqrt(Math.max(0.0, plane.secondOverGround()));
        double scale =
                leastSeparation() > 0.0 ? leastSeparation() / TurbulentCoherence.separation(source, sensor) : 0.0;
        return between(ground, length, scale * source, scale * sensor, 0.0).inBand(band, 1.0, reflected);
    }

    /** The least distance between direct and reflected sound, m; it applies only where sound bends up. */
    private double leastSeparation() {
        double apart = TurbulentCoherence.separation(plane.firstOverGround(), plane.secondOverGround());
        return bendsUp && apart > 0.0 ? LEAST_SEPARATION * apart : 0.0;
    }

    /** The interference at given heights above the reflecting plane. */
    private GroundInterference between(
            GroundImpedance ground, double straight, double source, double sensor, double unevenness) {
        double reflected = Math.sqrt(straight * straight + 4.0 * source * sensor);
        return new GroundInterference(
                ground, air.soundSpeed(), straight, reflected, source, sensor, unevenness, turbulence);
    }

    /** The interference above the plane found last, with rays at least {@link #leastSeparation} apart. */
    private GroundInterference interference(GroundImpedance ground, double straight, double length) {
        double source = plane.heightOfFirst();
        double sensor = plane.heightOfSecond();
        double raised = leastSeparation() / TurbulentCoherence.separation(source, sensor);
        // If the ends are raised, the unevenness is reduced, so that its effect remains that at the angle at which
        // sound arrives.
        return raised > 1.0
                ? between(ground, straight, raised * source, raised * sensor, plane.unevenness() / raised)
                : new GroundInterference(
                        ground, air.soundSpeed(), straight, length, source, sensor, plane.unevenness(), turbulence);
    }

    /**
     * The fraction of the energy that is reflected; with an impedance, the interference already accounts for
     * absorption.
     */
    private double reflected(int material, GroundImpedance impedance, int band, double cosine) {
        if (!isCoherent) {
            return surfaces.mirrored(material, band, cosine);
        }
        double left = 1.0 - SurfaceRoughness.scattered(surfaces.scattered(material, band), cosine);
        return impedance != null ? left : left * surfaces.reflected(material, band, cosine);
    }

    /**
     * The collection to which a first-order reflection at a point belongs: that of the reflections that interfere, or
     * that of the others. If sound travels along the ground, the reflection is part of that sound.
     */
    FoundPaths among(FoundPaths others, double x, double y, double z) {
        boolean isReplaced = isFound ? plane.covers(x, y, z) : isAlong && plane.isBelow(x, y, z);
        return isReplaced ? replaced : others;
    }

    /**
     * Adds the ground reflection to the direct sound, or, where walls dominate, to the other reflections.
     *
     * @param direct the direct sound; afterwards, direct and ground-reflected sound together
     * @param mirrored all other reflections
     */
    void addTo(FoundPaths direct, FoundPaths mirrored, SoundSource source, Position sensor) {
        if (!isFound) {
            return;
        }
        Position position = source.position();
        double straight = position.distance(sensor);
        double length = plane.length();
        double cosine = (plane.heightOfFirst() + plane.heightOfSecond()) / length;
        int material = plane.material();
        GroundImpedance impedance = materials.get(material).groundImpedance().orElse(null);
        GroundInterference interference =
                interference(impedance == null ? GroundImpedance.RIGID : impedance, straight, length);
        double others = 0.0;
        double together = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double reflected =
                    source.spread(air, band, plane.rise(), length) * reflected(material, impedance, band, cosine);
            others += mirrored.heard(band);
            together += direct.heard(band) + reflected;
            both[band] = isCoherent
                    ? interference.inBand(band, direct.heard(band), reflected)
                    : direct.heard(band) + reflected;
            if (bendsUp) {
                both[band] = Math.max(both[band], DEEPEST * direct.heard(band));
            }
        }
        if (isCoherent && others > together) {
            mirrored.add(replaced);
            return;
        }
        direct.clear();
        direct.add(straight, both);
    }
}
