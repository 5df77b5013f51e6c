package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sensor.acoustic.tone.LineSpectrum;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Tone;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** The standard error that a reading states is that of the quantity on which its detection is based. */
class DecisiveErrorTest {
    private static final EnergyModel ALL_RAYS =
            EnergyModel.DEFAULT.withRays(2000).withAccuracy(0.0);

    /** A room whose walls absorb and scatter differently in each band, so that each band has an error of its own. */
    private static World room(BandLevels noise) {
        List<Double> absorption = List.of(0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8);
        SurfaceMaterial plain = SurfaceMaterial.uniform("wall", 0.3, 0.5);
        SurfaceMaterial wall = new SurfaceMaterial(
                plain.name(),
                absorption,
                plain.scattering(),
                plain.transmissionLoss(),
                plain.wall(),
                plain.speed(),
                plain.source(),
                plain.angular(),
                plain.ground());
        return new World(
                KDTree.of(Sites.room(10, 8, 4)), BackgroundNoise.of(noise), List.of(wall), Atmosphere.STANDARD);
    }

    private static double error(Criterion criterion, BandLevels noise, LineSpectrum lines) {
        SoundSource source = Sites.broadband(new Position(2, 3, 1.5)).with(lines);
        return Sites.read(ALL_RAYS.withCriterion(criterion), room(noise), source, new Position(8, 6, 1.2), 1)
                .standardError();
    }

    @Test
    void ofALineItIsThatOfItsOctave() {
        List<Double> power = Collections.nCopies(8, Sites.LW);
        LineSpectrum line = new LineSpectrum(List.of(new Tone(1, 205.0, 1.0)), power, 0.0, 343.2, 0.0);
        BandLevels flat = BandLevels.flat(20.0);
        BandLevels quietAt250 = BandLevels.of(60, 60, 0, 60, 60, 60, 60, 60);
        double narrow = error(Criterion.NARROW_BAND, flat, line);
        assertThat(narrow).isPositive().isEqualTo(error(Criterion.BEST_BAND, quietAt250, LineSpectrum.NONE));
        assertThat(narrow).isNotEqualTo(error(Criterion.BEST_BAND, flat, line));
        assertThat(error(Criterion.NARROW_BAND, flat, LineSpectrum.NONE))
                .isEqualTo(error(Criterion.BEST_BAND, flat, LineSpectrum.NONE));
    }

    /**
     * What exact paths alone decide is as uncertain as the reading: the rays may have missed much, or found too much.
     */
    @Test
    void ofExactPathsAloneItIsThatOfTheWhole() {
        List<Double> some = Collections.nCopies(8, 100.0);
        EnergyAudit audit = new EnergyAudit(0, 0, 0, 0, 0, 0, 0);
        EnergyReading few = new EnergyReading(some, some, some, some, 5, 3.0, false, audit, new DecayCurve());
        assertThat(few.forDetection().standardError()).isEqualTo(3.0);
        assertThat(few.forDetection().level(0)).isLessThan(few.level(0));
        EnergyReading many = new EnergyReading(some, some, some, some, 5, 3.0, true, audit, new DecayCurve());
        assertThat(many.forDetection()).isEqualTo(many);
        assertThat(many.forDetection().standardError()).isEqualTo(3.0);
    }
}
