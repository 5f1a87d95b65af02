namespace Rabit.Uav.Communications;

/// <summary>How the rate of a link follows the free part of its radio's buffer.</summary>
public enum RadioBufferLaw
{
    /// <summary>
    /// As PX4: at each report times 0.8 below 25 %, 0.975 below 35 %, 1.025 above 50 %, within 1 to 100 %, of which
    /// 5 % are always used; 100 % after 5 s without a report (mavlink_main.cpp, update_radio_status and
    /// update_rate_mult, of 1.14; MAV_RADIO_TOUT).
    /// </summary>
    Px4,

    /// <summary>
    /// As ArduPilot, which lengthens the interval of its streams: at each report by 60 ms below 20 %, by 20 ms below
    /// 50 %, up to about 2 s; and shortens it by 40 ms above 95 % as long as it is more than 200 ms longer, else by
    /// 20 ms above 90 % (GCS_Common.cpp, handle_radio_status, of 4.5). Of streams at 4 Hz: 11 to 100 %.
    /// </summary>
    ArduPilot,
}
