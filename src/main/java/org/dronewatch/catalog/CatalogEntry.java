package org.dronewatch.catalog;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.world.WorldSettings;

/**
 * A real sensor: its settings and their source.
 *
 * @param title manufacturer's name for the sensor
 * @param source where the figures are published
 * @param basis the extent to which the settings are based on these figures
 * @param note assumptions, and the calibration of the settings
 * @param coverage description of the field of view
 * @param price price as text, with currency and year
 * @param ranges ranges that the manufacturer states; empty when none are published
 * @param sensor settings as in a scene file, without a position
 */
public record CatalogEntry(
        String title,
        String source,
        Basis basis,
        String note,
        String coverage,
        Optional<String> price,
        List<PublishedRange> ranges,
        Node.Mapping sensor) {

    /** The extent to which settings are based on published figures. */
    public enum Basis {
        /** All relevant figures are published. */
        PUBLISHED,
        /** Unpublished figures were chosen to give the published range. */
        CALIBRATED,
        /** No range is published; unpublished figures are assumed. */
        ASSUMED
    }

    /**
     * A range that a manufacturer states, as this library interprets it: for a straight approach over flat grass, with
     * the sensor and the drone 10 m above it.
     *
     * @param distance the range, m
     * @param target description of the target
     * @param drone settings of the drone for which the range holds, overriding those of the small quadrotor
     * @param world settings of the world in which the range holds, overriding those of a quiet world
     */
    public record PublishedRange(
            @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double distance,
            String target,
            Optional<Node.Mapping> drone,
            Optional<Node.Mapping> world) {
        /** Checks the limits. */
        public PublishedRange {
            Limits.check(PublishedRange.class, distance, target, drone, world);
        }

        /** A range, m, for the small quadrotor in a quiet world. */
        @Defaults({"distance", "target"})
        public static PublishedRange of(double distance, String target) {
            return new PublishedRange(distance, target, Optional.empty(), Optional.empty());
        }

        /** The drone for which the range holds, on a given flight. */
        public DroneSettings droneOn(FlightPathSettings flight) {
            Map<String, ?> quadrotor = Map.of("model", ModelSettings.packaged("quadrotor.obj"), "flight", flight);
            return read(quadrotor, drone, DroneSettings.class);
        }

        /** The world in which the range holds, with the given ground. */
        public WorldSettings worldOf(ModelSettings ground) {
            return read(Map.of("models", List.of(ground)), world, WorldSettings.class);
        }

        private static <T> T read(Map<String, ?> base, Optional<Node.Mapping> over, Class<T> type) {
            Node.Mapping plain = Node.Mapping.ofReady("catalogue", base);
            Node.Mapping whole = over.map(plain::overlaidWith).orElse(plain);
            return SettingsFile.read(whole, type, Kinds.FOUND, Path.of(""), new FormerNames());
        }
    }

    /**
     * Copies the list: later changes by the caller have no effect.
     *
     * @throws IllegalArgumentException when a component is missing, or when there are ranges although the basis is
     *     {@link Basis#ASSUMED}, or no ranges although it is not
     */
    public CatalogEntry {
        Limits.check(CatalogEntry.class, title, source, basis, note, coverage, price, ranges, sensor);
        ranges = List.copyOf(ranges);
        if (ranges.isEmpty() != (basis == Basis.ASSUMED)) {
            throw new IllegalArgumentException("basis is " + basis + " with " + Counted.of(ranges.size(), "range")
                    + ": an entry is 'assumed' if and only if no range is published");
        }
    }

    /** An entry without further information. */
    @Defaults({"title", "source", "basis", "coverage", "ranges", "sensor"})
    public static CatalogEntry of(
            String title,
            String source,
            Basis basis,
            String coverage,
            List<PublishedRange> ranges,
            Node.Mapping sensor) {
        return new CatalogEntry(title, source, basis, "", coverage, Optional.empty(), ranges, sensor);
    }

    /** The kind of the sensor in scene files; empty when the entry does not state it. */
    public String kind() {
        return sensor.text("kind").orElse("");
    }
}
