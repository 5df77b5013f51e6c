package org.dronewatch.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.dronewatch.geo.Origin;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.setting.Quantity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The origin of a scene in results: in degrees, as the scene file has it, to a millimetre on the ground. */
class OriginInResultTest {
    private static ObjectNode written(Origin origin) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        JsonFile.add(node, origin);
        return node;
    }

    @ParameterizedTest
    @CsvSource({"50.08, 15", "-33.856784, 151.215297", "90, -180", "0, 0", "50.12345678, -0.00000001"})
    void degreesAreThoseOfTheSceneFile(String latitude, String longitude) {
        Origin origin = Origin.at(Quantity.ANGLE.parse(latitude + " deg"), Quantity.ANGLE.parse(longitude + " deg"));
        ObjectNode node = written(origin);
        assertThat(node.get("latitude_deg").decimalValue()).isEqualByComparingTo(latitude);
        assertThat(node.get("longitude_deg").decimalValue()).isEqualByComparingTo(longitude);
        assertThat(node.has("height_m")).isFalse();
    }

    /** Half of the last of eight decimals is 0.6 mm on the equator. */
    @Test
    void whatIsRoundedIsLessThanAMillimetre() {
        SplittableRandom random = new SplittableRandom(25);
        for (int i = 0; i < 1000; i++) {
            double longitude = Math.PI * (2.0 * random.nextDouble() - 1.0);
            double there = Math.toRadians(
                    written(Origin.at(0.0, longitude)).get("longitude_deg").doubleValue());
            assertThat(6_378_137.0 * Math.abs(there - longitude))
                    .as("seed 25, number %d", i)
                    .isLessThan(6e-4);
        }
    }
}
