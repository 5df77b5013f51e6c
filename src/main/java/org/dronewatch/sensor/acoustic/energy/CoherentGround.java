package org.dronewatch.sensor.acoustic.energy;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.GroundPlane;
import org.dronewatch.sound.GroundImpedance;
import org.dronewatch.sound.GroundInterference;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.SurfaceMaterial;
import org.dronewatch.sound.SurfaceRoughness;
import org.dronewatch.sound.TurbulentCoherence;
import org.dronewatch.world.World;

/**
 * The interference of direct sound with sound reflected by the ground below it. It takes the place of the first-order
 * reflections within the ground's Fresnel zone, unless walls dominate: where other reflections carry more energy than both
 * together, phases are taken as random, that of the ground reflection included. Sound scattered by rough ground is left to
 * the rays. One per thread.
 */
final class CoherentGround {
    private static final int BANDS = OctaveBands.COUNT;

    /** The Fresnel zone is that of a sound in the middle of a drone's spectrum, Hz. */
    private static final double ZONE_FREQUENCY = 500.0;

    private final boolean isOn;
    private final GroundPlane plane;
    private final List<SurfaceMaterial> materials;
    private final BandSurfaces surfaces;
    private final Air air;
    private final TurbulentCoherence turbulence;
    private final FoundPaths replaced = new FoundPaths();
    private final double[] both = new double[BANDS];
    private boolean isFound;

    CoherentGround(EnergyModel model, World world, BandSurfaces surfaces, Air air) {
        this.isOn = model.ground() == EnergyModel.Ground.COHERENT;
        this.plane = new GroundPlane(world);
        this.materials = world.surfaces();
        this.surfaces = surfaces;
        this.air = air;
        this.turbulence = new TurbulentCoherence(model.turbulence(), model.turbulenceScale());
    }

    /**
     * Searches for the ground between a source and a sensor.
     *
     * @param isFree whether there is a line of sight; without direct sound there is nothing for the ground reflection to
     *     interfere with
     */
    void find(SoundSource source, Position sensor, boolean isFree) {
        replaced.clear();
        isFound = isOn && isFree && plane.find(source.position(), sensor, air.soundSpeed() / ZONE_FREQUENCY);
    }

    /** Whether there is ground that interferes: then its bumps are not edges but part of the reflection. */
    boolean isFound() {
        return isFound;
    }

    /** Where a first-order reflection at a point belongs: among those that interfere or among the others. */
    FoundPaths among(FoundPaths others, double x, double y, double z) {
        return isFound && plane.covers(x, y, z) ? replaced : others;
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
        GroundInterference interference = new GroundInterference(
                impedance == null ? GroundImpedance.RIGID : impedance,
                air.soundSpeed(),
                straight,
                length,
                plane.heightOfFirst(),
                plane.heightOfSecond(),
                plane.unevenness(),
                turbulence);
        double others = 0.0;
        double together = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double reflected = source.spread(air, band, plane.rise(), length)
                    * (1.0 - SurfaceRoughness.scattered(surfaces.scattered(material, band), cosine))
                    * (impedance == null ? surfaces.reflected(material, band, cosine) : 1.0);
            others += mirrored.heard(band);
            together += direct.heard(band) + reflected;
            both[band] = interference.inBand(band, direct.heard(band), reflected);
        }
        if (others > together) {
            mirrored.add(replaced);
            return;
        }
        direct.clear();
        direct.add(straight, both);
    }
}
