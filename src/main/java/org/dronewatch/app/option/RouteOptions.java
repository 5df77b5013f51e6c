package org.dronewatch.app.option;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.RouteHeights;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlightMode;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import picocli.CommandLine.Option;

/** The options of {@code route} that determine the cells over which it searches, and where the routes begin. */
public final class RouteOptions {
    private static final String LAUNCH = "--launch";
    private static final String MODES = "--modes";
    private static final String MODE_WORDS =
            "powered, slow or glide, or several of them in this order, such as powered,glide";
    private static final String RESPONSE = "--response";
    private static final String STOPPED = "--stopped";

    @Option(
            names = "--side",
            paramLabel = "L",
            description = "Length of a side of the area, centred on the protected zone or on the sensors; by"
                    + " default the area extends 250 m farther on each side than the drone flies during the response.")
    private String side;

    @Option(
            names = "--cell",
            paramLabel = "L",
            description = "Length of a cell's side; a hundredth of the area's side by default.")
    private String cell;

    @Option(
            names = "--heights",
            paramLabel = "H,H,...",
            description =
                    "Heights above the ground at which the drone may fly; by default 2, 5, 10, 20, 30, 45, 60, 90, 120, 150"
                            + " and 250 m, then twice as high each time, up to the drone's ceiling, which is the last.")
    private String heights;

    @Option(
            names = LAUNCH,
            paramLabel = "AREA",
            description = "Where the routes begin: a zone of the scene, or an area as scene files state it, such as"
                    + " '{centre: [0, 900], radius: 50 m}'; anywhere on the edge by default.")
    private String launch;

    @Option(
            names = RESPONSE,
            paramLabel = "S",
            description = "Time from a detection until the drone is stopped, in place of the scene's alert.response.")
    private String response;

    @Option(
            names = STOPPED,
            paramLabel = "P",
            description = "Probability that a response in time stops the drone, 0 to 1; if it is given, the"
                    + " probability that the drone is stopped is stated, too.")
    private Double stopped;

    @Option(
            names = "--pointing",
            paramLabel = "search|cued",
            description =
                    "Pointing of sensors on positioners: searching, or turned to the drone and zoomed in; search by"
                            + " default, since nothing has cued them before the first detection.")
    private String pointing;

    @Option(
            names = MODES,
            paramLabel = "powered,slow,glide",
            description = "Modes in which the drone may fly, one or several in this order: powered, at cruise speed;"
                    + " slow, below the minimum radial speed of a radar; glide, with its motors off, once at the end;"
                    + " by default, all modes in which it can fly and that make a difference to a sensor.")
    private String modes;

    /** Checks what can be checked before anything is loaded, and passes the response time on to the runner. */
    public void apply(SceneRunner runner) {
        given();
        length("side", side);
        length("cell", cell);
        pointing();
        words();
        if (stopped != null && !(stopped >= 0.0 && stopped <= 1.0)) {
            throw new InputException(STOPPED + " " + Quantity.RATIO.inWords(stopped) + ": must be 0 to 1");
        }
        if (response != null) {
            try {
                runner.set("alert.response", response);
                runner.settings();
            } catch (InputException e) {
                String asked = "--set alert.response=" + response + ": ";
                String fault = e.getMessage();
                if (fault.startsWith("--set ") && !fault.startsWith(asked)) {
                    throw e;
                }
                throw new InputException(
                        GivenOption.words(RESPONSE, response) + ": "
                                + (fault.startsWith(asked) ? fault.substring(asked.length()) : fault),
                        e);
            }
        }
    }

    /** How sensors on positioners point. */
    public FieldTerms.Turning pointing() {
        return pointing == null
                ? FieldTerms.Turning.SEARCH
                : FieldOptions.word("--pointing", pointing, FieldTerms.Turning.values(), "search or cued");
    }

    /** The probability that a response in time stops the drone; empty if none was given. */
    public Optional<Double> stopped(SceneSettings settings) {
        if (stopped != null && settings.alert().response() == 0.0) {
            throw new InputException(STOPPED + " " + Quantity.RATIO.inWords(stopped)
                    + ": needs the time of a response: --response, or alert.response of the scene");
        }
        return Optional.ofNullable(stopped);
    }

    /** The modes in which a drone may fly, in the order of {@link FlightMode.Kind}. */
    public List<FlightMode> modes(DroneSettings drone, Collection<SensorSettings<?>> sensors) {
        List<FlightMode> can = FlightMode.of(drone, sensors);
        List<FlightMode.Kind> asked =
                words().orElse(can.stream().map(FlightMode::kind).toList());
        for (FlightMode.Kind kind : asked) {
            if (can.stream().noneMatch(mode -> mode.kind() == kind)) {
                throw new InputException(GivenOption.words(MODES, modes) + ": " + reason(kind, drone));
            }
        }
        return can.stream().filter(mode -> asked.contains(mode.kind())).toList();
    }

    /** Why a drone cannot fly in a mode. */
    private static String reason(FlightMode.Kind kind, DroneSettings drone) {
        if (kind == FlightMode.Kind.GLIDE) {
            return "the drone cannot glide; performance.glideRatio is 0";
        }
        return drone.flightLimits().hover()
                ? "slow flight makes no difference: no sensor of the scene detects the drone at cruise speed but rejects it in slow flight"
                : "the drone cannot fly slowly; performance.hover is false";
    }

    private static String word(FlightMode.Kind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    private Optional<List<FlightMode.Kind>> words() {
        if (modes == null) {
            return Optional.empty();
        }
        List<String> words =
                Arrays.stream(modes.split(",", -1)).map(String::strip).toList();
        List<FlightMode.Kind> asked = Arrays.stream(FlightMode.Kind.values())
                .filter(kind -> words.contains(word(kind)))
                .toList();
        if (!words.equals(asked.stream().map(RouteOptions::word).toList())) {
            throw new InputException(GivenOption.words(MODES, modes) + ": must be " + MODE_WORDS);
        }
        return Optional.of(asked);
    }

    /**
     * The cells over which the search goes.
     *
     * @param middle centre of the area, m
     * @param usual length of the area's side unless another was given, m
     * @param ceiling greatest height of the drone above the ground, m, up to which there are cells unless heights were
     *     given
     */
    public FieldGrid grid(Position middle, double usual, double ceiling) {
        double across = length("side", side).orElse(usual);
        double edge = length("cell", cell).orElse(across / FieldGrid.DEFAULT_CELLS);
        FieldGrid grid;
        try {
            grid = new FieldGrid(
                    middle.x(), middle.y(), across, edge, given().orElseGet(() -> RouteHeights.upTo(ceiling)));
        } catch (IllegalArgumentException e) {
            throw new InputException("--cell: " + e.getMessage(), e);
        }
        if (grid.columns() < 2) {
            throw new InputException(
                    "--cell " + edge + " m: must be at most half the side of the area, " + across + " m");
        }
        return grid;
    }

    private static OptionalDouble length(String name, String text) {
        return text == null
                ? OptionalDouble.empty()
                : OptionalDouble.of((double) FieldOptions.value(name, text, FieldGrid.class, name));
    }

    /** The heights that were given, m. */
    private Optional<List<Double>> given() {
        return Optional.ofNullable(heights).map(GridOptions::heights);
    }

    /** The area from which the routes come, in plan view; empty for the edge of the area searched. */
    public Optional<AreaZone> launchArea(SceneRunner runner, SceneSettings settings) {
        if (launch == null) {
            return Optional.empty();
        }
        if (launch.strip().startsWith("{")) {
            return Optional.of(new AreaZone("launch", runner.area(LAUNCH, launch, settings), 0.0, 0.0));
        }
        return Optional.of(AreaZone.inPlan(launch, settings.alert())
                .orElseThrow(() -> new InputException(GivenOption.words(LAUNCH, launch)
                        + ": neither a zone of the scene nor an area such as '{centre: [0, 900], radius: 50 m}'")));
    }

    /** The area from which the routes come, as it was given; empty if none was. */
    public Optional<String> launch() {
        return Optional.ofNullable(launch);
    }
}
