package org.dronewatch.sensor.acoustic.level;

import java.util.List;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.AngularAbsorption;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;

/**
 * The surface properties that the level model uses: since it has no bands, these are the figures at 1 kHz, in flat
 * arrays.
 */
final class SurfaceLevels {
    /** Speed of sound in the open, m/s, at 20 degrees Celsius. */
    private static final double AIR_SPEED = 343.2;

    private final double[] reflectionLoss;
    private final double[] reflectedFraction;
    private final double[] transmissionLoss;
    private final double[] transmittedFraction;
    private final double[] speed;
    private final boolean[] transmits;
    private final boolean[] sheet;
    private final AngularAbsorption[] angular;

    SurfaceLevels(World world) {
        List<SurfaceMaterial> surfaces = world.surfaces();
        int count = surfaces.size();
        this.reflectionLoss = new double[count];
        this.reflectedFraction = new double[count];
        this.transmissionLoss = new double[count];
        this.transmittedFraction = new double[count];
        this.speed = new double[count];
        this.transmits = new boolean[count];
        this.sheet = new boolean[count];
        this.angular = new AngularAbsorption[count];
        for (int i = 0; i < count; i++) {
            SurfaceMaterial surface = surfaces.get(i);
            int band = OctaveBands.ONE_KILOHERTZ;
            reflectedFraction[i] = surface.reflected(band);
            reflectionLoss[i] = -Levels.ofRatio(reflectedFraction[i]);
            transmits[i] = !surface.isOpaque();
            transmittedFraction[i] = surface.transmitted(band);
            transmissionLoss[i] = -Levels.ofRatio(transmittedFraction[i]);
            speed[i] = surface.speed().orElse(AIR_SPEED);
            sheet[i] = surface.wall() == Wall.SHEET;
            angular[i] = surface.angular().orElse(null);
        }
    }

    /**
     * The loss of level by reflection, dB; infinity where nothing is reflected.
     *
     * @param cosine cosine of the angle between the sound and the normal
     */
    double reflectionLoss(int material, double cosine) {
        return angular[material] == null
                ? reflectionLoss[material]
                : -Levels.ofRatio(reflectedFraction(material, cosine));
    }

    /**
     * The fraction of the energy that is reflected.
     *
     * @param cosine cosine of the angle between the sound and the normal
     */
    double reflectedFraction(int material, double cosine) {
        return angular[material] == null
                ? reflectedFraction[material]
                : 1.0 - angular[material].at(OctaveBands.ONE_KILOHERTZ, cosine);
    }

    /** The loss of level on passing through the wall, dB. */
    double transmissionLoss(int material) {
        return transmissionLoss[material];
    }

    /**
     * The least loss of level at any surface, dB. Sound that leaves a solid wall loses nothing; if reflection depends
     * on the angle, sound is taken to lose nothing.
     */
    double leastLoss() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < reflectionLoss.length; i++) {
            double through = !transmits[i] ? Double.POSITIVE_INFINITY : sheet[i] ? transmissionLoss[i] : 0.0;
            least = Math.min(least, Math.min(angular[i] == null ? reflectionLoss[i] : 0.0, through));
        }
        return least;
    }

    double transmittedFraction(int material) {
        return transmittedFraction[material];
    }

    boolean transmits(int material) {
        return transmits[material];
    }

    boolean isSheet(int material) {
        return sheet[material];
    }

    /** Speed of sound in a medium, m/s. */
    double speed(int medium) {
        return medium == AcousticRay.AIR ? AIR_SPEED : speed[medium];
    }

    /**
     * Speed of sound behind a surface of a solid wall, m/s: that inside the wall for a ray from the open air, and that
     * outside for a ray from inside.
     */
    double speedBehind(int medium, int material) {
        return medium == AcousticRay.AIR ? speed[material] : AIR_SPEED;
    }
}
