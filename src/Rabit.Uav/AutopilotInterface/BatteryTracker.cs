using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Joins the two messages that report the first battery. Either may know a figure that the other does not; of two that
/// know it the newer counts.
/// </summary>
internal sealed class BatteryTracker
{
    // What one message knew fills the gaps of the other for this long: autopilots send both at least every 2 s.
    private static readonly TimeSpan FillsGapsFor = TimeSpan.FromSeconds(10);

    private const ushort NoVoltage = ushort.MaxValue;

    private BatteryReading _systemStatus = BatteryReading.Unknown;
    private BatteryReading _batteryStatus = BatteryReading.Unknown;

    /// <summary>Takes SYS_STATUS (voltage in mV, current in cA, remaining in %).</summary>
    public BatteryReading Take(in SysStatus message, TimeSpan time)
    {
        _systemStatus = new BatteryReading(
            time,
            message.VoltageBattery == NoVoltage ? double.NaN : message.VoltageBattery / 1000.0,
            Amperes(message.CurrentBattery),
            Fraction(message.BatteryRemaining));
        return _systemStatus.FilledFrom(_batteryStatus, FillsGapsFor);
    }

    /// <summary>Takes BATTERY_STATUS of battery 0.</summary>
    public BatteryReading Take(in BatteryStatus message, TimeSpan time)
    {
        _batteryStatus = new BatteryReading(
            time, Volts(message), Amperes(message.CurrentBattery), Fraction(message.BatteryRemaining),
            message.CurrentConsumed < 0 ? double.NaN : message.CurrentConsumed / 1000.0);
        return _batteryStatus.FilledFrom(_systemStatus, FillsGapsFor);
    }

    /// <summary>How many cells are reported one by one; 0 where it is the whole battery.</summary>
    public static int Cells(in BatteryStatus message)
    {
        UInt16Array10 cells = message.Voltages;
        UInt16Array4 furtherCells = message.VoltagesExt;
        int count = 0;
        for (int i = 0; i < cells.Length; i++)
            count += cells[i] is 0 or NoVoltage ? 0 : 1;
        for (int i = 0; i < furtherCells.Length; i++)
            count += furtherCells[i] is 0 or NoVoltage ? 0 : 1;
        return count > 1 ? count : 0;
    }

    // Cells one by one, or the whole battery in the first; 65535 is no cell. Cells 11 to 14 are extensions, where 0 is
    // no cell.
    private static double Volts(in BatteryStatus message)
    {
        UInt16Array10 cells = message.Voltages;
        UInt16Array4 furtherCells = message.VoltagesExt;
        int sum = 0;
        int known = 0;
        for (int i = 0; i < cells.Length; i++)
        {
            if (cells[i] == NoVoltage)
                continue;
            sum += cells[i];
            known++;
        }

        for (int i = 0; i < furtherCells.Length; i++)
            sum += furtherCells[i] == NoVoltage ? 0 : furtherCells[i];
        return known == 0 ? double.NaN : sum / 1000.0;
    }

    // Only -1 is "not known": less is a battery that is being charged.
    private static double Amperes(short centiamperes) => centiamperes == -1 ? double.NaN : centiamperes / 100.0;

    private static double Fraction(sbyte percent) => percent is < 0 or > 100 ? double.NaN : percent / 100.0;
}
