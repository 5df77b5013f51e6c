package org.dronewatch.flight.track;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;

/**
 * Dates with times of day in files, as in ISO 8601; a time without a zone counts as UTC, since only differences matter.
 */
final class LogTime {
    private static final double NANO = 1e-9;

    private LogTime() {}

    /**
     * Seconds since 1970.
     *
     * @throws DateTimeException when the text is not such a time
     */
    static double seconds(String text) {
        String plain = text.strip().replaceFirst("^(\\d{4}-\\d{2}-\\d{2}) ", "$1T");
        boolean hasZone = plain.matches(".*(Z|z|[+-]\\d{2}:?\\d{2})$") && plain.indexOf('T') > 0;
        Instant instant = hasZone
                ? OffsetDateTime.parse(plain.replaceFirst("([+-]\\d{2})(\\d{2})$", "$1:$2"))
                        .toInstant()
                : LocalDateTime.parse(plain).toInstant(ZoneOffset.UTC);
        return instant.getEpochSecond() + NANO * instant.getNano();
    }
}
