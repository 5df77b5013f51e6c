package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.placement.site.ZoneCoverage;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.html.Html;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** The coverage of the layout and of the scene's own sensors, zone by zone, if some zones count more than others. */
final class ZoneTable {
    private static final String ROW = "%24s  %8s  %8s  %8s  %8s";
    private static final String OTHERS = "all other cells";
    private static final List<String> HEAD = List.of("zone", "weight", "cells", "today", "layout");

    private final List<ZoneCoverage> zones;
    private final String average;

    ZoneTable(SitePlacement best) {
        this.zones = best.byZone();
        this.average = PlaceMeasure.of(best.plan()).headingsClause();
    }

    /** Whether the zones have weights. */
    boolean isNeeded() {
        return !zones.isEmpty();
    }

    /** An empty line and the table; nothing where no zone has a weight. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        if (isNeeded()) {
            lines.addAll(
                    List.of("", "coverage of each zone, unweighted, in % of its cells" + average + ":", row(HEAD)));
            rows().forEach(row -> lines.add(row(row)));
        }
        return lines;
    }

    private static String row(List<String> words) {
        return PlaceTable.text(ROW, words.toArray());
    }

    private List<List<String>> rows() {
        return zones.stream()
                .map(zone -> List.of(
                        name(zone),
                        Numbers.text(zone.weight()),
                        Integer.toString(zone.cells()),
                        percent(zone.present()),
                        percent(OptionalDouble.of(zone.layout()))))
                .toList();
    }

    private static String name(ZoneCoverage zone) {
        return zone.zone().isEmpty() ? OTHERS : zone.zone();
    }

    private static String percent(OptionalDouble fraction) {
        return fraction.isEmpty()
                ? HeightFigures.NONE
                : PlaceTable.text("%.1f", FrontWords.PERCENT * fraction.getAsDouble());
    }

    /** The section of the report. */
    String html() {
        return Html.plain(
                        "p",
                        "Cells in these zones are given more or less weight than all others; a cell that lies in several"
                                + " of them has the greatest of their weights. The fractions of the airspace in this"
                                + " report are weighted. The figures in this table are not: each is a percentage of the"
                                + " cells of its zone, all of which count the same" + average + ".")
                + Html.table(HEAD, rows());
    }

    /** Adds {@code zones} where they have weights. */
    void add(ObjectNode root) {
        if (isNeeded()) {
            ArrayNode array = root.putArray("zones");
            for (ZoneCoverage zone : zones) {
                ObjectNode node = array.addObject();
                node.put("zone", zone.zone().isEmpty() ? null : zone.zone());
                node.put("weight", Numbers.rounded(zone.weight()));
                node.put("cells", zone.cells());
                node.put("layout", Numbers.rounded(zone.layout()));
                node.put(
                        "present",
                        zone.present().isPresent()
                                ? Numbers.rounded(zone.present().getAsDouble())
                                : null);
            }
        }
    }
}
