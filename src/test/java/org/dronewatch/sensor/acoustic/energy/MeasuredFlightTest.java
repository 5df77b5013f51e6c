package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.DroneSound;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The packaged sound of a DJI Matrice 300, flown as it was measured (doi 10.1016/j.ast.2023.108537): 10 m above
 * microphones on plates on hard ground.
 */
class MeasuredFlightTest {
    private static final Position DRONE = new Position(0, 0, 10);
    private static final World FIELD = Sites.world(Sites.square(300, 0), SurfaceMaterials.get("asphalt"));

    /** 84.8 dB(A) at 1 m, 20 dB less for the distance, 6 dB more on the plate. */
    @Test
    void straightBelowThePredictionIsWithinADecibel() {
        assertThat(onPlate(0.0, EnergyModel.Ground.COHERENT)).isCloseTo(70.8, within(1.0));
        assertThat(onPlate(0.0, EnergyModel.Ground.INCOHERENT)).isCloseTo(67.8, within(1.0));
    }

    /**
     * To the side: the mean of both sides in the published table at 1 m, A-weighted, when the drone is abeam; the model
     * has the mean over all headings, which differs by up to 2 dB.
     */
    @ParameterizedTest
    @CsvSource({"15, 85.0", "30, 84.9", "45, 83.8", "60, 81.75"})
    void besideTheTrackItFollowsTheDirectivity(double degrees, double abeam) {
        double across = 10.0 * Math.tan(Math.toRadians(degrees));
        double distance = Math.hypot(10.0, across);
        assertThat(onPlate(across, EnergyModel.Ground.COHERENT))
                .isCloseTo(abeam - 20.0 * Math.log10(distance) + 6.0, within(2.0));
    }

    private static double onPlate(double across, EnergyModel.Ground ground) {
        DroneSound sound = DroneSounds.get("m300");
        List<Double> power = sound.octaves(sound.level());
        SoundSource drone = new SoundSource(DRONE, power, Directivity.M300);
        EnergyModel model = EnergyModel.DEFAULT.withGround(ground).withRays(4000);
        return Sites.read(model, FIELD, drone, new Position(across, 0, 0), 1).aWeightedLevel();
    }
}
