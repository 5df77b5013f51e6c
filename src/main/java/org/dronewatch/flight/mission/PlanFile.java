package org.dronewatch.flight.mission;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.JsonText;
import tools.jackson.databind.JsonNode;

/**
 * A plan of QGroundControl: a JSON file with a mission, whose items are commands of MAVLink. A file with an unsupported
 * command that moves the drone is rejected; commands that do not move it are left out and reported.
 *
 * @param hash name of the file and the hash of its bytes
 * @param home launch position of the drone; empty if the plan does not state it
 * @param homeHeight height of the launch position above sea level, as stated in the plan, m
 * @param speed speed of the vehicle, m/s
 * @param steps the steps of the mission
 * @param warnings a line for each item that is left out or flown differently
 * @param items number of items of the mission
 */
record PlanFile(
        FileHash hash,
        Optional<EarthPoint> home,
        OptionalDouble homeHeight,
        OptionalDouble speed,
        List<MissionStep> steps,
        List<String> warnings,
        int items) {
    /** The greatest number of items of a mission, including those of its surveys. */
    static final int MOST_ITEMS = 10_000;

    private static final double FASTEST = 400.0;

    PlanFile {
        steps = List.copyOf(steps);
        warnings = List.copyOf(warnings);
    }

    /**
     * Reads a plan.
     *
     * @param name name of the file in messages
     * @throws InputException when it is not a plan, or has an item that is not supported
     */
    static PlanFile read(String name, byte[] bytes) {
        return new Reading(PlainText.value(name)).plan(name, bytes);
    }

    /** Reads one file. */
    private static final class Reading {
        private final String name;
        private final PlanNumbers numbers;
        private final List<MissionStep> steps = new ArrayList<>();
        private final List<String> warnings = new ArrayList<>();
        private final Map<Integer, List<String>> still = new TreeMap<>();
        private int items;

        Reading(String name) {
            this.name = name;
            this.numbers = new PlanNumbers(name);
        }

        PlanFile plan(String named, byte[] bytes) {
            JsonNode root = JsonText.read(name, bytes);
            String type = root.path("fileType").asString("");
            if (!type.equals("Plan")) {
                throw new InputException(name + ": fileType is '" + PlainText.value(type)
                        + "' but must be 'Plan': not a QGroundControl plan");
            }
            JsonNode mission = root.path("mission");
            if (!mission.path("items").isArray()) {
                throw new InputException(name + ": mission.items is missing: the plan has no mission");
            }
            int vehicle = mission.path("vehicleType").asInt(2);
            if (MissionCommands.isOnTheGround(vehicle)) {
                throw new InputException(name + ": mission.vehicleType " + vehicle + " is a vehicle that does not fly");
            }
            items(mission.path("items"), "mission.items");
            still.forEach((command, where) -> warnings.add(where.get(0)
                    + (where.size() == 1 ? "" : " and " + (where.size() - 1) + " more") + ": "
                    + MissionCommands.inWords(command) + " does not move the drone, and is left out"));
            for (String fence :
                    List.of("geoFence.circles", "geoFence.polygons", "geoFence.polygon", "rallyPoints.points")) {
                String[] part = fence.split("\\.");
                if (!root.path(part[0]).path(part[1]).isEmpty()) {
                    warnings.add(fence + ": it has no effect on the flight, and is left out");
                }
            }
            JsonNode home = mission.path("plannedHomePosition");
            Optional<EarthPoint> launch = home.isArray() && home.size() >= 2
                    ? Optional.of(numbers.point(home.get(0), home.get(1), "mission.plannedHomePosition"))
                    : Optional.empty();
            OptionalDouble launchHeight = home.path(2).isNumber()
                    ? OptionalDouble.of(numbers.number(
                            home.get(2),
                            "mission.plannedHomePosition",
                            "height",
                            -PlanNumbers.HIGHEST,
                            PlanNumbers.HIGHEST))
                    : OptionalDouble.empty();
            String which = MissionCommands.isWinged(vehicle) ? "cruiseSpeed" : "hoverSpeed";
            JsonNode stated = mission.path(which);
            OptionalDouble speed = stated.isNumber() && stated.doubleValue() > 0.0
                    ? OptionalDouble.of(numbers.number(stated, "mission", which, 0.001, FASTEST))
                    : OptionalDouble.empty();
            return new PlanFile(hash(named, bytes), launch, launchHeight, speed, steps, warnings, items);
        }

        private static FileHash hash(String name, byte[] bytes) {
            try {
                return FileHash.of(name, new ByteArrayInputStream(bytes));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        private void items(JsonNode list, String path) {
            int number = 0;
            for (JsonNode item : list) {
                item(item, path + "." + number++);
            }
        }

        private void item(JsonNode item, String where) {
            String type = item.path("type").asString("");
            if (type.equals("SimpleItem")) {
                if (++items > MOST_ITEMS) {
                    throw new InputException(name + ": more than " + MOST_ITEMS + " items");
                }
                command(item, where);
            } else if (type.equals("ComplexItem")) {
                complex(item, where);
            } else {
                throw new InputException(name + ": " + where + ": type '" + PlainText.value(type)
                        + "' must be SimpleItem or ComplexItem");
            }
        }

        /**
         * Reads a complex item: a landing pattern, or a survey, for which QGroundControl writes the simple items to be
         * flown beside the settings from which it computed them.
         */
        private void complex(JsonNode item, String where) {
            String kind = item.path("complexItemType").asString("");
            JsonNode transects = item.path("TransectStyleComplexItem").path("Items");
            if (kind.equals("fwLandingPattern") || kind.equals("vtolLandingPattern")) {
                landing(item, kind.startsWith("vtol"), where);
            } else if (transects.isArray()) {
                for (JsonNode inner : transects) {
                    if (!inner.path("type").asString("").equals("SimpleItem")) {
                        throw new InputException(name + ": " + where
                                + ".TransectStyleComplexItem.Items: has an item that is not simple");
                    }
                }
                items(transects, where + ".TransectStyleComplexItem.Items");
            } else {
                throw new InputException(name + ": " + where + ": complex item '" + PlainText.value(kind)
                        + "' is not supported: only surveys, corridors and landing patterns are");
            }
        }

        private void landing(JsonNode item, boolean isVtol, String where) {
            JsonNode approach = item.path("landingApproachCoordinate").isArray()
                    ? item.path("landingApproachCoordinate")
                    : item.path("loiterCoordinate");
            JsonNode land = item.path("landCoordinate");
            MissionStep.Frame frame =
                    item.path("altitudesAreRelative").asBoolean(true) ? MissionStep.Frame.HOME : MissionStep.Frame.SEA;
            double height =
                    numbers.number(approach.path(2), where, "height", -PlanNumbers.HIGHEST, PlanNumbers.HIGHEST);
            warnings.add(where + ": the drone does not circle before it lands");
            steps.add(new MissionStep.FlyTo(
                    where,
                    numbers.point(approach.path(0), approach.path(1), where),
                    new MissionStep.Height(frame, height),
                    0.0));
            EarthPoint spot = numbers.point(land.path(0), land.path(1), where);
            steps.add(isVtol ? new MissionStep.Land(where, Optional.of(spot)) : new MissionStep.TouchDown(where, spot));
        }

        private void command(JsonNode item, String where) {
            JsonNode number = item.path("command");
            if (!number.isInt()) {
                throw new InputException(name + ": " + where + ".command: must be the number of a MAVLink command");
            }
            int command = number.intValue();
            if (MissionCommands.isStill(command)) {
                still.computeIfAbsent(command, unseen -> new ArrayList<>()).add(where);
                return;
            }
            JsonNode params = numbers.parameters(item, where);
            moving(command, item, params, where);
            if (item.path("autoContinue").isBoolean()
                    && !item.path("autoContinue").booleanValue()) {
                steps.add(new MissionStep.Stay(where));
            }
        }

        private void moving(int command, JsonNode item, JsonNode params, String where) {
            switch (command) {
                case MissionCommands.WAYPOINT, MissionCommands.SPLINE_WAYPOINT, MissionCommands.LOITER_TIME -> {
                    if (command == MissionCommands.SPLINE_WAYPOINT) {
                        warnings.add(where + ": a spline is flown as straight lines");
                    }
                    if (command == MissionCommands.LOITER_TIME) {
                        warnings.add(where + ": the drone hovers here, although the plan may have it circle");
                    }
                    steps.add(new MissionStep.FlyTo(
                            where,
                            numbers.place(params, where),
                            numbers.height(item, params, where),
                            numbers.wait(params, where)));
                }
                case MissionCommands.LOITER_UNLIMITED -> {
                    steps.add(new MissionStep.FlyTo(
                            where, numbers.place(params, where), numbers.height(item, params, where), 0.0));
                    steps.add(new MissionStep.Stay(where));
                }
                case MissionCommands.TAKE_OFF, MissionCommands.VTOL_TAKE_OFF ->
                    steps.add(new MissionStep.TakeOff(
                            where, numbers.placeIfAny(params, where), numbers.height(item, params, where)));
                case MissionCommands.LAND, MissionCommands.VTOL_LAND ->
                    steps.add(new MissionStep.Land(where, numbers.placeIfAny(params, where)));
                case MissionCommands.RETURN_TO_LAUNCH -> {
                    warnings.add(
                            where + ": the drone returns at its current height, since the plan does not state another");
                    steps.add(new MissionStep.Return(where));
                }
                case MissionCommands.DELAY -> {
                    if (!(params.get(0).isNumber() && params.get(0).doubleValue() >= 0.0)) {
                        throw new InputException(
                                name + ": " + where + ": a delay until a time of day is not supported");
                    }
                    steps.add(new MissionStep.Wait(where, numbers.wait(params, where)));
                }
                case MissionCommands.CHANGE_SPEED -> speed(params, where);
                default ->
                    throw new InputException(name + ": " + where + ": " + MissionCommands.inWords(command)
                            + " is not supported, and may move the drone");
            }
        }

        private void speed(JsonNode params, String where) {
            double type = params.get(0).isNumber() ? params.get(0).doubleValue() : 1.0;
            if (type != 0.0 && type != 1.0) {
                warnings.add(where + ": a change of climb or descent speed is left out");
                return;
            }
            double speed = params.get(1).isNumber() ? params.get(1).doubleValue() : -1.0;
            if (speed == -1.0 || speed == -2.0) {
                // In MAVLink, these values mean no change, or a return to the default.
                warnings.add(where + ": a change of speed that states no speed is left out");
                return;
            }
            steps.add(new MissionStep.Speed(where, numbers.number(params.get(1), where, "speed", 0.001, FASTEST)));
        }
    }
}
