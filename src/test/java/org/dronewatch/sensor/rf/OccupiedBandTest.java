package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Bands in which others transmit. */
class OccupiedBandTest {
    private static final RfSettings RECEIVER = RfSettings.at(new Position(0, 0, 0));

    private static OccupiedBand between(double from, double to) {
        return new OccupiedBand(-60.0, 1.0, RadioBand.ISM_2400, Optional.of(from), Optional.of(to));
    }

    @ParameterizedTest
    @EnumSource(RadioBand.class)
    void aBandIncludesBothOfItsEdges(RadioBand band) {
        OccupiedBand occupied = OccupiedBand.of(-60.0, 1.0).withBand(band);
        assertThat(occupied.contains(band.minFrequency())).isTrue();
        assertThat(occupied.contains(band.maxFrequency())).isTrue();
        assertThat(occupied.contains(0.5 * (band.minFrequency() + band.maxFrequency())))
                .isTrue();
        assertThat(occupied.contains(Math.nextDown(band.minFrequency()))).isFalse();
        assertThat(occupied.contains(Math.nextUp(band.maxFrequency()))).isFalse();
    }

    @Test
    void anEdgeReplacesThatOfTheBand() {
        OccupiedBand upper = new OccupiedBand(-60.0, 1.0, RadioBand.ISM_2400, Optional.of(2450e6), Optional.empty());
        assertThat(upper.contains(2449e6)).isFalse();
        assertThat(upper.contains(2450e6)).isTrue();
        assertThat(upper.contains(2483.5e6)).isTrue();
        OccupiedBand wider = new OccupiedBand(-60.0, 1.0, RadioBand.ISM_2400, Optional.empty(), Optional.of(2500e6));
        assertThat(wider.contains(2400e6)).isTrue();
        assertThat(wider.contains(2500e6)).isTrue();
        assertThat(wider.contains(2501e6)).isFalse();
        assertThatThrownBy(() -> between(200e6, 200e6))
                .hasMessage("minFrequency 2.0E8 Hz must be below maxFrequency 2.0E8 Hz");
        assertThatThrownBy(() -> between(201e6, 200e6)).hasMessageContaining("must be below maxFrequency");
        assertThat(between(200e6, Math.nextUp(200e6)).contains(200e6)).isTrue();
    }

    /** -60 dBm in each megahertz. */
    @ParameterizedTest
    @CsvSource({"1e6, -60", "1e7, -50", "1e8, -40", "2e7, -46.9897", "1e5, -70", "1e4, -80", "1, -120"})
    void thePowerGrowsWithTheBandwidth(double bandwidth, double dbm) {
        assertThat(OccupiedBand.of(-60.0, 0.5).power(bandwidth)).isCloseTo(dbm, within(1e-4));
    }

    /** Against a band from 200 to 300 MHz. Bands include their edges, so two that touch share a frequency. */
    @ParameterizedTest
    @CsvSource({
        "100e6, 199e6, false",
        "100e6, 199999999, false",
        "100e6, 200e6, true",
        "100e6, 250e6, true",
        "100e6, 400e6, true",
        "200e6, 300e6, true",
        "220e6, 280e6, true",
        "250e6, 400e6, true",
        "300e6, 400e6, true",
        "300000001, 400e6, false",
        "301e6, 400e6, false"
    })
    void bandsOverlapWhereTheyShareAFrequency(double from, double to, boolean isShared) {
        OccupiedBand fixed = between(200e6, 300e6);
        OccupiedBand other = between(from, to);
        assertThat(fixed.overlaps(other)).isEqualTo(isShared);
        assertThat(other.overlaps(fixed)).isEqualTo(isShared);
    }

    /** In whichever order they are stated, and whatever they are called. */
    @Test
    void aReceiverRefusesBandsThatOverlapOnly() {
        OccupiedBand low = between(100e6, 200e6);
        OccupiedBand high = between(200e6, 300e6);
        OccupiedBand apart = between(Math.nextUp(200e6), 300e6);
        assertThatThrownBy(() -> RECEIVER.withOccupied("a", low).withOccupied("b", high))
                .hasMessage("occupied bands 'a' and 'b' overlap");
        assertThatThrownBy(() -> RECEIVER.withOccupied("b", low).withOccupied("a", high))
                .hasMessage("occupied bands 'a' and 'b' overlap");
        assertThat(RECEIVER.withOccupied("a", low).withOccupied("b", apart).occupied())
                .isEqualTo(Map.of("a", low, "b", apart));
        assertThat(RECEIVER.withOccupied("b", low).withOccupied("a", apart).occupied())
                .isEqualTo(Map.of("b", low, "a", apart));
    }

    @Test
    void allNamedBandsTogetherAreApartAndEachIsFoundAtItsFrequencies() {
        RfSettings crowded = RECEIVER;
        for (RadioBand band : RadioBand.values()) {
            crowded = crowded.withOccupied(
                    band.name(), OccupiedBand.of(-60.0, 1.0).withBand(band));
        }
        for (RadioBand band : RadioBand.values()) {
            assertThat(crowded.occupiedAt(band.minFrequency()).orElseThrow().getKey())
                    .isEqualTo(band.name());
            assertThat(crowded.occupiedAt(band.maxFrequency()).orElseThrow().getKey())
                    .isEqualTo(band.name());
        }
        assertThat(crowded.occupiedAt(2490e6)).isEmpty();
        assertThat(crowded.rise(2490e6)).isZero();
        assertThat(crowded.rise(2500e6)).isGreaterThan(40.0);
    }
}
