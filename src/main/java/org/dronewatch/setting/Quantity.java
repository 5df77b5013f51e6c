package org.dronewatch.setting;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.djunits.value.vdouble.scalar.AbsoluteTemperature;
import org.djunits.value.vdouble.scalar.Acceleration;
import org.djunits.value.vdouble.scalar.Angle;
import org.djunits.value.vdouble.scalar.AngularVelocity;
import org.djunits.value.vdouble.scalar.Area;
import org.djunits.value.vdouble.scalar.Duration;
import org.djunits.value.vdouble.scalar.Frequency;
import org.djunits.value.vdouble.scalar.Length;
import org.djunits.value.vdouble.scalar.Mass;
import org.djunits.value.vdouble.scalar.Power;
import org.djunits.value.vdouble.scalar.Pressure;
import org.djunits.value.vdouble.scalar.Speed;
import org.djunits.value.vdouble.scalar.Temperature;

/** A physical quantity, the SI unit in which it is kept, and how it is read from a text such as {@code 39.6 deg}. */
public enum Quantity {
    /** Metres. */
    LENGTH("m", unit -> Length.valueOf(unit).si),
    /** Radians. */
    ANGLE("rad", unit -> Angle.valueOf(unit).si),
    /** Radians per second. */
    ANGULAR_SPEED("rad/s", unit -> AngularVelocity.valueOf(unit).si),
    /** Seconds. */
    DURATION("s", unit -> Duration.valueOf(unit).si),
    /** Metres per second. */
    SPEED("m/s", unit -> Speed.valueOf(unit).si),
    /** Metres per second squared. */
    ACCELERATION("m/s2", unit -> Acceleration.valueOf(unit).si),
    /** Hertz. */
    FREQUENCY("Hz", unit -> Frequency.valueOf(unit).si),
    /** Square metres. */
    AREA("m2", unit -> Area.valueOf(unit).si),
    /** Kelvin; a value in degrees Celsius or Fahrenheit is a temperature, not a temperature difference. */
    TEMPERATURE("K", unit -> AbsoluteTemperature.valueOf(unit).si),
    /** Kelvin, for the difference between two temperatures. */
    TEMPERATURE_DIFFERENCE("K", unit -> Temperature.valueOf(unit).si),
    /** Pascals. */
    PRESSURE("Pa", unit -> Pressure.valueOf(unit).si),
    /** Kilograms. */
    MASS("kg", unit -> Mass.valueOf(unit).si),
    /** Watts. */
    POWER("W", unit -> Power.valueOf(unit).si),
    /** A fraction, usually 0 to 1; percentages are accepted. */
    RATIO("", Quantity::share),
    /** A level in dB, relative to the reference of each setting. */
    LEVEL("dB", Quantity::unitOfItself),
    /** Kelvin per metre of height. */
    TEMPERATURE_GRADIENT("K/m", Quantity::unitOfItself),
    /** Decibels per metre. */
    ATTENUATION("dB/m", Quantity::unitOfItself),
    /** Rain, millimetres per hour. */
    PRECIPITATION("mm/h", Quantity::unitOfItself),
    /** Lux. */
    ILLUMINANCE("lx", Quantity::unitOfItself),
    /** Refractive-index structure parameter Cn^2 of turbulent air. */
    REFRACTIVE_INDEX_STRUCTURE("m^-2/3", Quantity::unitOfItself),
    /** Pixels. */
    PIXELS("px", Quantity::unitOfItself),
    /** A plain number. */
    NUMBER("", Quantity::unitOfItself);

    private static final Pattern NUMBER_AND_UNIT =
            Pattern.compile("([-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?)\\s*(\\S*)");
    private static final int LONGEST = 60;

    /**
     * Below the first and from the second of these two numbers on, powers of ten are shorter, and easier to compare.
     */
    private static final double SMALLEST_PLAIN = 1e-4;

    private static final double LARGEST_PLAIN = 1e6;
    /** A radian value with at most this many characters was probably typed, not converted from degrees. */
    private static final int LONGEST_WRITTEN = 12;
    /** Display precision at which 200 deg survives the round trip through radians. */
    private static final MathContext DISPLAYED = new MathContext(7);

    private static final MathContext BRIEF = new MathContext(4);

    /** This many digits distinguish any number from its neighbours. */
    private static final int DIGITS_OF_DOUBLE = 17;

    private final String unit;
    private final ToDoubleFunction<String> ofOneUnit;

    Quantity(String unit, ToDoubleFunction<String> ofOneUnit) {
        this.unit = unit;
        this.ofOneUnit = ofOneUnit;
    }

    /** The unit of a bare number, such as {@code m/s}; empty for a plain number. */
    public String unit() {
        return unit;
    }

    /**
     * The unit in which a value is displayed: degrees for angles, degrees per second for angular speeds, otherwise that
     * of a bare number.
     */
    public String displayUnit() {
        return switch (this) {
            case ANGLE -> "deg";
            case ANGULAR_SPEED -> "deg/s";
            default -> unit;
        };
    }

    /** Converts a value from the unit of this quantity to that in which it is displayed. */
    public double displayed(double value) {
        if (unit.equals(displayUnit()) || !Double.isFinite(value)) {
            return value;
        }
        return new BigDecimal(Math.toDegrees(value)).round(DISPLAYED).doubleValue();
    }

    /**
     * A value as shown in tables and plots, without its unit: whole numbers unchanged, others to four significant
     * digits.
     */
    public String inBrief(double value) {
        double shown = displayed(value);
        return shown == Math.rint(shown) || !Double.isFinite(shown)
                ? plain(shown)
                : new BigDecimal(shown).round(BRIEF).stripTrailingZeros().toPlainString();
    }

    /** A value as displayed, without its unit. */
    String number(double value) {
        return plain(displayed(value));
    }

    /**
     * A value as displayed, with its unit: {@code 39.6 deg}. If a number of degrees was probably taken as radians, that
     * number is added: {@code 3437.747 deg (60 rad)}.
     */
    public String inWords(double value) {
        String shown = (number(value) + " " + displayUnit()).strip();
        return bare(value)
                .map(written -> shown + " (" + written + " " + unit + ")")
                .orElse(shown);
    }

    /**
     * For a value that is displayed in another unit, the number that was probably typed without a unit: {@code 60} if
     * an angle of 60 rad may have been meant to be 60 degrees. Empty for a value with many digits, which was probably
     * converted.
     */
    public Optional<String> bare(double value) {
        String written = plain(value);
        boolean isTyped = !unit.equals(displayUnit())
                && Double.isFinite(value)
                && value != 0.0
                && written.length() <= LONGEST_WRITTEN;
        return isTyped ? Optional.of(written) : Optional.empty();
    }

    /**
     * A value for a file, with its unit: {@link #parse} returns exactly this value. Angles are in degrees if the value
     * can be written exactly in degrees, otherwise in radians.
     *
     * @param value the value, finite
     */
    public String exactly(double value) {
        double inDegrees = Math.toDegrees(value);
        if (unit.equals(displayUnit()) || !Double.isFinite(inDegrees)) {
            return withUnit(shortest(value), unit);
        }
        BigDecimal degrees = new BigDecimal(inDegrees);
        for (int digits = 1; digits <= DIGITS_OF_DOUBLE; digits++) {
            double rounded = degrees.round(new MathContext(digits)).doubleValue();
            String text = withUnit(shortest(rounded), displayUnit());
            if (Double.doubleToLongBits(parse(text)) == Double.doubleToLongBits(value)) {
                return text;
            }
        }
        return withUnit(shortest(value), unit);
    }

    private static String withUnit(String number, String unit) {
        return unit.isEmpty() ? number : number + " " + unit;
    }

    private static String shortest(double value) {
        return Double.toString(value).replaceFirst("\\.0$", "");
    }

    /** A number as a person would write it: {@code 0.5}, {@code 10000}, {@code 1e-12}, {@code 2.4e9}. */
    static String plain(double value) {
        if (!Double.isFinite(value)) {
            return Double.toString(value);
        }
        BigDecimal shortest = BigDecimal.valueOf(value).stripTrailingZeros();
        String plain = shortest.toPlainString();
        double size = Math.abs(value);
        if (size == 0.0 || size >= SMALLEST_PLAIN && size < LARGEST_PLAIN) {
            return plain;
        }
        int exponent = shortest.precision() - shortest.scale() - 1;
        String power = shortest.movePointLeft(exponent).toPlainString() + "e" + exponent;
        return power.length() < plain.length() ? power : plain;
    }

    /**
     * Reads a value.
     *
     * @param text a number, optionally followed by a unit of this quantity: {@code 5}, {@code 5 m/s}, {@code 18 km/h}
     * @return the value in this quantity's unit
     * @throws IllegalArgumentException when the text is not a number or the unit is not one of this quantity
     */
    public double parse(String text) {
        Matcher matcher = NUMBER_AND_UNIT.matcher(text.strip());
        if (text.length() > LONGEST || !matcher.matches()) {
            throw new IllegalArgumentException(
                    "'" + PlainText.beginning(text, LONGEST) + "' is not a number" + orWithUnit());
        }
        double number = Double.parseDouble(matcher.group(1));
        String written = KnownUnits.meant(this, matcher.group(2));
        if (written.isEmpty() || written.equals(unit)) {
            return number;
        }
        // The whole "1 unit" goes to the units library, which depends on the locale for anything but plain integers.
        try {
            double one = ofOneUnit.applyAsDouble("1 " + written);
            // Degrees Celsius do not begin where kelvins do.
            double zero = this == TEMPERATURE ? ofOneUnit.applyAsDouble("0 " + written) : 0.0;
            return zero + number * (one - zero);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "'" + text.strip() + "': " + mistaken(written) + KnownUnits.hint(this, written), e);
        }
    }

    private String mistaken(String written) {
        return unit.isEmpty() ? "expected a number" + orWithUnit() : "'" + written + "' is not a unit of " + inWords();
    }

    private String orWithUnit() {
        if (this == RATIO) {
            return " from 0 to 1, or a percentage with %";
        }
        return unit.isEmpty() ? " without a unit" : " in " + unit + " or another unit of " + inWords();
    }

    private String inWords() {
        return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    private static double share(String oneUnit) {
        if (oneUnit.equals("1 %")) {
            return 0.01;
        }
        throw new IllegalArgumentException(oneUnit + " is not a fraction");
    }

    private static double unitOfItself(String text) {
        throw new IllegalArgumentException(text + " has another unit");
    }
}
