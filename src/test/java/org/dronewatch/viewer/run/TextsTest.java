package org.dronewatch.viewer.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;

class TextsTest {
    @Test
    void nothingIsWrittenAsMinusZero() {
        assertThat(Texts.place(new Position(-0.04, -0.0, -0.06))).isEqualTo("east 0.0 m, north 0.0 m, up -0.1 m");
    }

    @Test
    void anObserverWhoCouldFindTheDroneNeedsMoreTime() {
        assertThat(new PairReading(1.0, 0.9, Double.POSITIVE_INFINITY, "", 50).text())
                .isEqualTo("0.90 (needs more search time)");
        assertThat(new PairReading(1.0, 0.9, 0.25, "", 50).text()).isEqualTo("0.90 (needs 0.25)");
    }

    @Test
    void aDetectionOverUnknownGroundSaysSo() {
        Observation known = new Observation(
                new LookId("north", "radar", 7, 75.5), "intruder", 812.34, new Reading(14.26, 13.0, "dB"));
        String plain = "1:15.50  north detects intruder at 812.3 m (14.3 dB, needs 13 dB)";
        assertThat(Events.text(new DetectionEvent(0, true, known))).isEqualTo(plain);
        assertThat(Events.text(new DetectionEvent(0, true, known.asUnknown())))
                .isEqualTo(plain + " over unknown ground");
        assertThat(Events.text(new DetectionEvent(0, false, known))).contains(" north loses intruder ");
    }

    private static WorldSettings at(Origin origin) {
        return SettingsForm.with(WorldSettings.EMPTY, "origin", Optional.of(origin));
    }

    /** A degree of latitude at 45 degrees is 111,132 m, and one of longitude 78,847 m. */
    @Test
    void aPlaceOfARealSiteHasItsLatitudeAndLongitude() {
        Position place = new Position(788.47, 1111.32, 60);
        Origin known = Origin.at(Math.toRadians(45), Math.toRadians(10)).withHeight(0.0);
        assertThat(Texts.place(place, at(known)))
                .startsWith("east 788.5 m, north 1111.3 m, up 60.0 m; 45.0")
                .containsPattern("45\\.0(0999|1000)\\d\u00b0 N, 10\\.01000\\d\u00b0 E, 60\\.1 m above sea level");
        Origin south = Origin.at(Math.toRadians(-45), Math.toRadians(-10));
        assertThat(Texts.place(place, at(south))).contains("\u00b0 S, ").endsWith("\u00b0 W");
        assertThat(Texts.place(place, WorldSettings.EMPTY)).isEqualTo(Texts.place(place));
    }
}
