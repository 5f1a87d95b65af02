using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// A command with its addressee and parameters, whichever of the two messages carries it. A plain value. Make it with
/// <see cref="Create"/>, or with <see cref="AtPlace"/> where it has a latitude, a longitude or an altitude.
/// </summary>
public readonly record struct MavlinkCommand
{
    private const double DegreesPerUnit = 1e-7;
    private const double MetresPerUnit = 1e-4;

    /// <summary>Who is to do it.</summary>
    public MavlinkAddress Target { get; init; }

    /// <summary>What to do.</summary>
    public MavCmd Command { get; init; }

    /// <summary>Which messages may carry it, and which first.</summary>
    public MavlinkCommandForms Forms { get; init; }

    /// <summary>Whether <see cref="X"/>, <see cref="Y"/> and <see cref="Z"/> are a place in <see cref="Frame"/>.</summary>
    public bool HasPlace { get; init; }

    /// <summary>The frame of the place; it goes out in COMMAND_INT only.</summary>
    public MavFrame Frame { get; init; }

    /// <summary>Parameter 1, in the unit of the command.</summary>
    public float Param1 { get; init; }

    /// <summary>Parameter 2, in the unit of the command.</summary>
    public float Param2 { get; init; }

    /// <summary>Parameter 3, in the unit of the command.</summary>
    public float Param3 { get; init; }

    /// <summary>Parameter 4, in the unit of the command.</summary>
    public float Param4 { get; init; }

    /// <summary>Parameter 5 of a command without a place.</summary>
    public float Param5 { get; init; }

    /// <summary>Parameter 6 of a command without a place.</summary>
    public float Param6 { get; init; }

    /// <summary>Of a place: latitude in 1e-7 degrees, or metres * 1e4 in a local frame.</summary>
    public int X { get; init; }

    /// <summary>Of a place: longitude in 1e-7 degrees, or metres * 1e4 in a local frame.</summary>
    public int Y { get; init; }

    /// <summary>Of a place: altitude in metres, in its frame; otherwise parameter 7.</summary>
    public float Z { get; init; }

    /// <summary>A command whose parameters are plain numbers, as COMMAND_LONG first.</summary>
    /// <param name="target">Who is to do it.</param>
    /// <param name="command">What to do.</param>
    /// <param name="param1">Parameter 1.</param>
    /// <param name="param2">Parameter 2.</param>
    /// <param name="param3">Parameter 3.</param>
    /// <param name="param4">Parameter 4.</param>
    /// <param name="param5">Parameter 5.</param>
    /// <param name="param6">Parameter 6.</param>
    /// <param name="param7">Parameter 7.</param>
    /// <returns>The command.</returns>
    public static MavlinkCommand Create(
        MavlinkAddress target, MavCmd command, float param1 = 0, float param2 = 0, float param3 = 0, float param4 = 0, float param5 = 0, float param6 = 0, float param7 = 0) => new()
        {
            Target = target,
            Command = command,
            Forms = MavlinkCommandForms.LongThenInt,
            Param1 = param1,
            Param2 = param2,
            Param3 = param3,
            Param4 = param4,
            Param5 = param5,
            Param6 = param6,
            Z = param7,
        };

    /// <summary>A command with a place, as COMMAND_INT first: single floats place a vehicle no better than a metre.</summary>
    /// <param name="target">Who is to do it.</param>
    /// <param name="command">What to do.</param>
    /// <param name="frame">What <paramref name="z"/> counts from.</param>
    /// <param name="x">Latitude in 1e-7 degrees, or metres * 1e4 in a local frame.</param>
    /// <param name="y">Longitude in 1e-7 degrees, or metres * 1e4 in a local frame.</param>
    /// <param name="z">Altitude in metres.</param>
    /// <param name="param1">Parameter 1.</param>
    /// <param name="param2">Parameter 2.</param>
    /// <param name="param3">Parameter 3.</param>
    /// <param name="param4">Parameter 4.</param>
    /// <returns>The command.</returns>
    public static MavlinkCommand AtPlace(
        MavlinkAddress target, MavCmd command, MavFrame frame, int x, int y, float z, float param1 = 0, float param2 = 0, float param3 = 0, float param4 = 0) => new()
        {
            Target = target,
            Command = command,
            Forms = MavlinkCommandForms.IntThenLong,
            HasPlace = true,
            Frame = frame,
            Param1 = param1,
            Param2 = param2,
            Param3 = param3,
            Param4 = param4,
            X = x,
            Y = y,
            Z = z,
        };

    internal CommandLong ToLong(byte confirmation) => new()
    {
        TargetSystem = Target.SystemId,
        TargetComponent = Target.ComponentId,
        Command = Command,
        Confirmation = confirmation,
        Param1 = Param1,
        Param2 = Param2,
        Param3 = Param3,
        Param4 = Param4,
        Param5 = HasPlace ? ToFloat(X) : Param5,
        Param6 = HasPlace ? ToFloat(Y) : Param6,
        Param7 = Z,
    };

    internal CommandInt ToInt() => new()
    {
        TargetSystem = Target.SystemId,
        TargetComponent = Target.ComponentId,
        Command = Command,
        Frame = Frame,
        Param1 = Param1,
        Param2 = Param2,
        Param3 = Param3,
        Param4 = Param4,
        X = HasPlace ? X : ToInteger(Param5),
        Y = HasPlace ? Y : ToInteger(Param6),
        Z = Z,
    };

    // The largest integer is "not given", as NaN is for floats.
    private float ToFloat(int value) => value == int.MaxValue ? float.NaN : (float)(value * (IsLocal ? MetresPerUnit : DegreesPerUnit));

    private static int ToInteger(float value) => float.IsNaN(value) ? int.MaxValue
        : value >= int.MaxValue ? int.MaxValue
        : value <= int.MinValue ? int.MinValue
        : (int)Math.Round(value);

    private bool IsLocal => Frame is MavFrame.LocalNed or MavFrame.LocalEnu or MavFrame.LocalOffsetNed or MavFrame.BodyNed or MavFrame.BodyOffsetNed
        or MavFrame.BodyFrd or MavFrame.LocalFrd or MavFrame.LocalFlu;
}
