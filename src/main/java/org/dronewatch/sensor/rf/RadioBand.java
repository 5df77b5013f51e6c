package org.dronewatch.sensor.rf;

/** A band that other transmitters occupy. Only its edges are given, since its occupancy differs from place to place. */
public enum RadioBand {
    /** 433.05 to 434.79 MHz, short-range devices (CEPT ERC/REC 70-03, annex 1). */
    ISM_433(433.05e6, 434.79e6),
    /** 863 to 870 MHz, short-range devices (CEPT ERC/REC 70-03, annex 1). */
    SRD_868(863e6, 870e6),
    /** 2400 to 2483.5 MHz, WLAN, Bluetooth and others (ETSI EN 300 328). */
    ISM_2400(2400e6, 2483.5e6),
    /** 5725 to 5875 MHz, WLAN, video links and others (CEPT ERC/REC 70-03, annex 1). */
    ISM_5800(5725e6, 5875e6),
    /** 832 to 862 MHz, uplink of phones in LTE band 20 (3GPP TS 36.101, table 5.5-1). */
    LTE_800_UPLINK(832e6, 862e6),
    /** 880 to 915 MHz, uplink of phones in LTE band 8 (3GPP TS 36.101, table 5.5-1). */
    LTE_900_UPLINK(880e6, 915e6),
    /** 1710 to 1785 MHz, uplink of phones in LTE band 3 (3GPP TS 36.101, table 5.5-1). */
    LTE_1800_UPLINK(1710e6, 1785e6),
    /** 2500 to 2570 MHz, uplink of phones in LTE band 7 (3GPP TS 36.101, table 5.5-1). */
    LTE_2600_UPLINK(2500e6, 2570e6);

    private final double minFrequency;
    private final double maxFrequency;

    RadioBand(double minFrequency, double maxFrequency) {
        this.minFrequency = minFrequency;
        this.maxFrequency = maxFrequency;
    }

    /** The lower edge, Hz. */
    public double minFrequency() {
        return minFrequency;
    }

    /** The upper edge, Hz. */
    public double maxFrequency() {
        return maxFrequency;
    }
}
