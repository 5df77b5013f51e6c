package org.dronewatch.terrain.io;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.setting.InputException;

/**
 * What GDAL writes about a GeoTIFF's samples, in its private tag 42112.
 *
 * @param name of the file in messages
 * @param text of the tag, XML; empty if there is none
 */
record GdalMetadata(String name, String text) {
    /** A factor with which GDAL's programs store heights as whole numbers; by its role, scale or offset. */
    double factor(String role, double otherwise) {
        Matcher matcher = Pattern.compile("<Item [^>]*role=\"" + role + "\"[^>]*>([^<]*)</Item>")
                .matcher(text);
        if (!matcher.find()) {
            return otherwise;
        }
        try {
            double value = Double.parseDouble(matcher.group(1).strip());
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Reported below, as for a number that is not finite.
        }
        throw new InputException(
                name + ": " + role + " (tag 42112) '" + matcher.group(1) + "' must be a finite number");
    }
}
