package org.dronewatch.placement.plan;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.dronewatch.geo.LocalPlace;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.Candidate;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Places;
import org.dronewatch.world.Visibility;

/** The sensors that a placement file offers, at each of their positions and with each of their aims. */
final class CandidatesOnSite {
    /** Maximum number of candidates. */
    private static final int MOST = 1000;

    private static final double FULL_TURN = 360.0;

    /** Decimal places of an angle in degrees: those that rounding errors do not affect. */
    private static final int DECIMALS = 9;

    private static final String OFFERS = "candidates.";

    private final PlaceSettings settings;
    private final SceneSettings present;
    private final Kinds kinds;
    private final Path directory;
    private final Places places;
    private final Predicate<Position> link;
    private final List<SiteCandidate> all = new ArrayList<>();
    private final Set<String> names = new HashSet<>();
    private final Set<String> kept = new HashSet<>();

    CandidatesOnSite(PlaceSettings settings, SceneSettings present, SceneRunner runner, Kinds kinds, Path directory) {
        this.settings = settings;
        this.present = present;
        this.kinds = kinds;
        this.directory = directory;
        this.places = new Places(present.world(), () -> runner.world(present).newGround());
        this.link = link(settings, present, runner);
        settings.keep().forEach(this::keep);
        settings.candidates().forEach(this::offer);
    }

    List<SiteCandidate> all() {
        return all;
    }

    private void keep(String id) {
        Map<String, SensorSettings<?>> sensors = present.enabledSensors();
        if (!sensors.containsKey(id)) {
            throw new InputException("keep: there is no enabled sensor '" + PlainText.value(id) + "'; "
                    + Spelling.closestMatches(id, sensors.keySet()));
        }
        // Kept sensors may stand together; whatever is exclusive may not join them.
        String place = sensors.get(id).position().toString();
        String taken = kept.add(place) ? place : "";
        add("keep", new SiteCandidate(new Candidate(id, 0.0, "", taken, true), sensors.get(id)));
    }

    private void offer(String name, OfferSettings offer) {
        List<Position> positions = positions(OFFERS + name, offer);
        if (positions.isEmpty()) {
            throw new InputException(OFFERS + name + ": has no place: needs 'places', a 'line' or an 'area'");
        }
        int width = String.valueOf(positions.size()).length();
        int before = all.size();
        for (int place = 0; place < positions.size(); place++) {
            if (!link.test(positions.get(place))) {
                continue;
            }
            String number = String.format(Locale.ROOT, "%s-%0" + width + "d", name, place + 1);
            fixed(name, offer, number, positions.get(place));
            turning(name, offer, number, positions.get(place));
        }
        if (all.size() == before) {
            throw new InputException(OFFERS + name + ": none of its places has a line of sight to conditions.base");
        }
    }

    /** Adds a sensor at a position, with each of its aims. */
    private void fixed(String name, OfferSettings offer, String number, Position place) {
        SensorSettings<?> sensor = sensor(OFFERS + name, offer.sensor(), place);
        for (int aim = 0; aim < offer.aims(); aim++) {
            String id = offer.aims() == 1 ? number : number + "-" + Math.round(360.0 * aim / offer.aims());
            add(name, offer, id, offer.price(), turned(OFFERS + name, sensor, aim, offer.aims()));
        }
    }

    /** Adds the sensor on each of its positioners. */
    private void turning(String name, OfferSettings offer, String number, Position place) {
        if (!offer.positioners().isEmpty() && offer.sensor().values().containsKey("positioner")) {
            throw new InputException(OFFERS + name + ".positioners: the sensor already has a positioner");
        }
        offer.positioners().forEach((mount, choice) -> {
            Node.Mapping mounted = offer.sensor()
                    .overlaidWith(Node.Mapping.ofNodes(OFFERS + name, Map.of("positioner", choice.positioner())));
            double price = offer.price() + choice.price();
            add(name, offer, number + "-" + mount, price, sensor(OFFERS + name, mounted, place));
        });
    }

    private void add(String name, OfferSettings offer, String id, double price, SensorSettings<?> sensor) {
        String taken = offer.exclusive() ? sensor.position().toString() : "";
        add(OFFERS + name, new SiteCandidate(new Candidate(id, price, name, taken, false), sensor));
    }

    /** Whether a position has a line of sight to the base station: true for all if there is none. */
    private static Predicate<Position> link(PlaceSettings settings, SceneSettings present, SceneRunner runner) {
        return settings.conditions()
                .base()
                .<Predicate<Position>>map(base -> {
                    Visibility visibility = new Visibility(runner.world(present));
                    return place -> visibility.isFree(place, base);
                })
                .orElse(place -> true);
    }

    private List<Position> positions(String path, OfferSettings offer) {
        List<Position> positions = new ArrayList<>(offer.places());
        offer.line().ifPresent(line -> line.points(MOST)
                .forEach(point -> positions.add(above(path + ".line", point, line.above()))));
        offer.area().ifPresent(area -> points(path + ".area", area)
                .forEach(point -> positions.add(above(path + ".area", point, area.above()))));
        return positions;
    }

    private static List<GroundPoint> points(String path, AreaOfPlaces area) {
        try {
            return area.points(MOST);
        } catch (IllegalArgumentException e) {
            throw new InputException(path + "." + e.getMessage(), e);
        }
    }

    private Position above(String path, GroundPoint point, double height) {
        try {
            return places.at(new LocalPlace(point.x(), point.y(), height));
        } catch (IllegalArgumentException e) {
            throw new InputException(path + ": " + e.getMessage(), e);
        }
    }

    private SensorSettings<?> sensor(String path, Node.Mapping sensor, Position position) {
        if (sensor.values().containsKey("position")) {
            throw new InputException(path + ".sensor.position: must not be given here, but as a place");
        }
        Node.Mapping placed = sensor.overlaidWith(Node.Mapping.ofReady(path, Map.of("position", position)));
        try {
            return SettingsFile.read(
                            Node.Mapping.ofNodes(path, Map.of("sensor", placed)),
                            Offered.class,
                            kinds,
                            directory,
                            new FormerNames())
                    .sensor();
        } catch (InputException e) {
            throw new InputException(e.getMessage().replace(": sensor", ": " + path + ".sensor"), e);
        }
    }

    /** A sensor alone. */
    private record Offered(SensorSettings<?> sensor) {}

    /** One of several aims, evenly spaced around the compass from its own azimuth. */
    private static SensorSettings<?> turned(String path, SensorSettings<?> sensor, int number, int of) {
        if (of == 1) {
            return sensor;
        }
        Aimed aimed = sensor.as(Aimed.class)
                .orElseThrow(() -> new InputException(path + ".aims " + of + ": a sensor of kind " + sensor.kind()
                        + " has no aim, so aims must be 1"));
        if (number > 0 && aimed.aim() instanceof Aim.Direction own) {
            // In degrees, so that the scene of a layout has the same angles as the file.
            double degrees = Math.toDegrees(own.azimuth()) + FULL_TURN * number / of;
            double rounded = BigDecimal.valueOf(Math.IEEEremainder(degrees, FULL_TURN))
                    .setScale(DECIMALS, RoundingMode.HALF_EVEN)
                    .doubleValue();
            return aimed.withAim(new Aim.Direction(Quantity.ANGLE.parse(rounded + " deg"), own.elevation()));
        }
        Position forward = aimed.aim().from(sensor.position());
        double level = Math.hypot(forward.x(), forward.y());
        double azimuth = StrictMath.atan2(forward.x(), forward.y()) + 2.0 * Math.PI * number / of;
        double elevation = StrictMath.atan2(forward.z(), level);
        return number == 0
                ? sensor
                : aimed.withAim(new Aim.Direction(StrictMath.IEEEremainder(azimuth, 2.0 * Math.PI), elevation));
    }

    private void add(String path, SiteCandidate candidate) {
        boolean isOfScene = !path.equals("keep") && present.sensors().containsKey(candidate.name());
        if (path.equals("keep") && names.contains(candidate.name())) {
            throw new InputException("keep: '" + PlainText.value(candidate.name()) + "' is named twice");
        }
        if (isOfScene || !names.add(candidate.name())) {
            throw new InputException(path + ": the name " + candidate.name() + " is taken by another sensor"
                    + (isOfScene ? " of the scene" : "") + ": rename it");
        }
        if (all.size() == MOST) {
            throw new InputException(path + ": more than " + MOST + " candidates: fewer places or aims are needed");
        }
        all.add(candidate);
    }
}
