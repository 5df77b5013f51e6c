package org.dronewatch.flight.mission;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** The MAVLink mission commands (MAV_CMD, common.xml) that are flown, and those that do not move a drone. */
final class MissionCommands {
    static final int WAYPOINT = 16;
    static final int LOITER_UNLIMITED = 17;
    static final int LOITER_TIME = 19;
    static final int RETURN_TO_LAUNCH = 20;
    static final int LAND = 21;
    static final int TAKE_OFF = 22;
    static final int SPLINE_WAYPOINT = 82;
    static final int VTOL_TAKE_OFF = 84;
    static final int VTOL_LAND = 85;
    static final int DELAY = 93;
    static final int CHANGE_SPEED = 178;

    /** Commands for cameras, gimbals, servos and marks, which have no effect on the position of the drone. */
    private static final Map<Integer, String> STILL = new TreeMap<>(Map.ofEntries(
            Map.entry(112, "CONDITION_DELAY"),
            Map.entry(114, "CONDITION_DISTANCE"),
            Map.entry(115, "CONDITION_YAW"),
            Map.entry(181, "DO_SET_RELAY"),
            Map.entry(182, "DO_REPEAT_RELAY"),
            Map.entry(183, "DO_SET_SERVO"),
            Map.entry(184, "DO_REPEAT_SERVO"),
            Map.entry(189, "DO_LAND_START"),
            Map.entry(195, "DO_SET_ROI_LOCATION"),
            Map.entry(196, "DO_SET_ROI_WPNEXT_OFFSET"),
            Map.entry(197, "DO_SET_ROI_NONE"),
            Map.entry(198, "DO_SET_ROI_SYSID"),
            Map.entry(200, "DO_CONTROL_VIDEO"),
            Map.entry(201, "DO_SET_ROI"),
            Map.entry(202, "DO_DIGICAM_CONFIGURE"),
            Map.entry(203, "DO_DIGICAM_CONTROL"),
            Map.entry(204, "DO_MOUNT_CONFIGURE"),
            Map.entry(205, "DO_MOUNT_CONTROL"),
            Map.entry(206, "DO_SET_CAM_TRIGG_DIST"),
            Map.entry(207, "DO_FENCE_ENABLE"),
            Map.entry(211, "DO_GRIPPER"),
            Map.entry(214, "DO_SET_CAM_TRIGG_INTERVAL"),
            Map.entry(530, "SET_CAMERA_MODE"),
            Map.entry(531, "SET_CAMERA_ZOOM"),
            Map.entry(532, "SET_CAMERA_FOCUS"),
            Map.entry(534, "SET_CAMERA_SOURCE"),
            Map.entry(1000, "DO_GIMBAL_MANAGER_PITCHYAW"),
            Map.entry(1001, "DO_GIMBAL_MANAGER_CONFIGURE"),
            Map.entry(2000, "IMAGE_START_CAPTURE"),
            Map.entry(2001, "IMAGE_STOP_CAPTURE"),
            Map.entry(2500, "VIDEO_START_CAPTURE"),
            Map.entry(2501, "VIDEO_STOP_CAPTURE"),
            Map.entry(3000, "DO_VTOL_TRANSITION")));

    /** Some commands that move the drone in ways that are not supported. */
    private static final Map<Integer, String> OTHERS = Map.ofEntries(
            Map.entry(18, "NAV_LOITER_TURNS"),
            Map.entry(30, "NAV_CONTINUE_AND_CHANGE_ALT"),
            Map.entry(31, "NAV_LOITER_TO_ALT"),
            Map.entry(92, "NAV_GUIDED_ENABLE"),
            Map.entry(94, "NAV_PAYLOAD_PLACE"),
            Map.entry(113, "CONDITION_CHANGE_ALT"),
            Map.entry(176, "DO_SET_MODE"),
            Map.entry(177, "DO_JUMP"),
            Map.entry(179, "DO_SET_HOME"),
            Map.entry(185, "DO_FLIGHTTERMINATION"),
            Map.entry(193, "DO_PAUSE_CONTINUE"),
            Map.entry(194, "DO_SET_REVERSE"),
            Map.entry(208, "DO_PARACHUTE"),
            Map.entry(222, "DO_GUIDED_LIMITS"),
            Map.entry(223, "DO_ENGINE_CONTROL"));

    private static final Set<Integer> WINGED = Set.of(1, 19, 20, 21, 22, 23, 24, 25);
    private static final Set<Integer> ON_THE_GROUND = Set.of(10, 11, 12);

    private MissionCommands() {}

    /** Whether a command leaves the drone where it is. */
    static boolean isStill(int command) {
        return STILL.containsKey(command);
    }

    /** A command's number, with its name if that is known. */
    static String inWords(int command) {
        String name = STILL.getOrDefault(command, OTHERS.getOrDefault(command, ""));
        return name.isEmpty() ? "command " + command : name + " (" + command + ")";
    }

    /**
     * Whether a type of vehicle (MAV_TYPE) has wings and flies at its cruise speed; others fly at their hover speed.
     */
    static boolean isWinged(int vehicle) {
        return WINGED.contains(vehicle);
    }

    /** Whether a type of vehicle travels on land or water. */
    static boolean isOnTheGround(int vehicle) {
        return ON_THE_GROUND.contains(vehicle);
    }
}
