package org.dronewatch.scenario;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;

/**
 * The prices of the sensors, for the report.
 *
 * @param currency currency of all prices, 1 to 12 letters, such as {@code EUR}
 * @param sensors known prices by sensor name, each 0 or more; they may include mount and installation
 */
public record PriceSettings(String currency, Map<String, Double> sensors) {
    /** No prices are known. */
    @Defaults
    public static final PriceSettings DEFAULT = new PriceSettings("EUR", Map.of());

    /** Checks the limits and copies the map. */
    public PriceSettings {
        if (!Check.present("currency", currency).matches("[A-Za-z]{1,12}")) {
            throw new IllegalArgumentException("currency '" + currency + "' must be 1 to 12 letters");
        }
        sensors = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("sensors", sensors)));
        sensors.forEach((sensor, price) -> {
            if (!(price >= 0.0 && price <= 1e12)) {
                throw new IllegalArgumentException("sensors." + sensor + " " + price + " must be 0 to 1e12");
            }
        });
    }
}
