package org.dronewatch.report.route;

import java.awt.Color;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.report.sheet.ProtectedOutlines;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.run.Stage;

/** The plan of a site with its weakest routes, coloured by how exposed the drone is on them. */
public final class RoutePictures {
    private static final Color ZONE = new Color(0x0b3d91);

    private final Stage stage;
    private final RouteInputs inputs;

    /** Pictures of the results of a search. */
    public RoutePictures(Stage stage, RouteInputs inputs) {
        this.stage = stage;
        this.inputs = inputs;
    }

    /**
     * The plan of the site with the weakest routes.
     *
     * @param ground the shaded ground, as {@link MapSheet#ground} returns it
     */
    public MapSheet plan(RouteSurvey survey, int[] ground) {
        MapSheet sheet = new MapSheet(inputs.grid());
        sheet.drawMap(
                ground, (column, row) -> (u, v, below) -> ColourMix.of(below, Color.WHITE, 0.25), inputs.sensors());
        for (List<Position> zone : ProtectedOutlines.of(stage.protection())) {
            sheet.outline(zone, ZONE);
        }
        survey.routes().forEach(route -> draw(sheet, route));
        survey.routes().forEach(route -> slow(sheet, route, survey));
        survey.routes().forEach(route -> motorsOff(route, survey).ifPresent(sheet::square));
        sheet.frame();
        survey.routes().forEach(route -> sheet.label(start(route), abbreviation(route)));
        legend(sheet, survey);
        sheet.credits(stage.credits());
        sheet.caption(
                "The weakest route from each direction; the darker and thicker a line, the more exposed the drone.");
        return sheet;
    }

    private static void draw(MapSheet sheet, SectorRoute route) {
        List<List<RoutePoint>> pieces = RoutePieces.of(route);
        // The edges first, so that none lies over the colour of another piece.
        pieces.forEach(
                piece -> sheet.draw(positions(piece), Color.BLACK, style(piece).width() + 2f));
        pieces.forEach(piece ->
                sheet.draw(positions(piece), style(piece).colour(), style(piece).width()));
    }

    private static RouteColours style(List<RoutePoint> piece) {
        return RouteColours.of(piece.get(0), piece.get(1));
    }

    private static List<Position> positions(List<RoutePoint> piece) {
        return piece.stream().map(RoutePoint::position).toList();
    }

    /** Draws dashes where the drone flies slowly. */
    private static void slow(MapSheet sheet, SectorRoute route, RouteSurvey survey) {
        RoutePieces.of(route).stream()
                .filter(piece -> ModeWords.isIn(survey, RouteMode::isSlow, piece.get(0)))
                .forEach(piece -> sheet.dashes(positions(piece)));
    }

    /** Where the drone stops its motors; empty if it does not. */
    private static Optional<Position> motorsOff(SectorRoute route, RouteSurvey survey) {
        return route.searched().points().stream()
                .filter(point -> ModeWords.isIn(survey, RouteMode::isGlide, point))
                .map(RoutePoint::position)
                .findFirst();
    }

    private static Position start(SectorRoute route) {
        return route.profile().points().get(0).position();
    }

    /** {@code NW}. */
    private static String abbreviation(SectorRoute route) {
        StringBuilder letters = new StringBuilder();
        for (String word : RouteWords.sector(route).split("-")) {
            letters.append(Character.toUpperCase(word.charAt(0)));
        }
        return letters.toString();
    }

    private void legend(MapSheet sheet, RouteSurvey survey) {
        sheet.title(inputs.scene());
        sheet.line("weakest routes of the drone '" + inputs.drone() + "'");
        sheet.line("to " + inputs.targetInWords());
        if (survey.response() > 0.0) {
            sheet.line("for a response of " + Numbers.text(survey.response()) + " s;");
        }
        sheet.line("chance of a detection within a second:");
        sheet.space();
        for (RouteColours style : RouteColours.values()) {
            sheet.sample(style.colour(), style.width(), style.words());
        }
        if (ModeWords.areSlow(survey)) {
            sheet.sampleDashes("slowed to " + ModeWords.slowSpeeds(survey));
        }
        if (ModeWords.areGlides(survey)) {
            sheet.squareSample("motors off from here");
        }
        sheet.space();
        sheet.line(survey.response() > 0.0 ? "from: detected (in time)" : "from: detected");
        for (SectorRoute route : survey.routes()) {
            String timely =
                    survey.response() > 0.0 ? " (" + RouteNumbers.percent(route.inTime(survey.response())) + ")" : "";
            sheet.line(abbreviation(route) + ": " + RouteNumbers.percent(route.detection()) + timely);
        }
        sheet.space();
        if (!stage.protection().isEmpty()) {
            sheet.sample(ZONE, "protected zone");
        }
        sheet.line("cells of " + Numbers.text(inputs.grid().cell()) + " m");
    }
}
