using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// A command with its target and parameters, for COMMAND_LONG and COMMAND_INT alike. A plain value. Make it with
/// <see cref="Create"/>, or with <see cref="AtLocation"/> where it has a latitude, a longitude or an altitude.
/// </summary>
/// <remarks>
/// Of a location the parameters 5, 6 and 7 of COMMAND_LONG are <see cref="X"/>, <see cref="Y"/> and <see cref="Z"/> of
/// COMMAND_INT.
/// </remarks>
/// <example>
/// <code>
/// var vehicle = new MavlinkAddress(1, 1);
/// MavlinkCommand arm = MavlinkCommand.Create(vehicle, MavCmd.ComponentArmDisarm, param1: 1);
/// MavlinkCommand fly = MavlinkCommand.AtLocation(
///     vehicle, MavCmd.DoReposition, MavFrame.GlobalRelativeAlt, x: 473_000_000, y: 85_000_000, z: 30, param1: -1);
/// </code>
/// </example>
public readonly record struct MavlinkCommand
{
    private const double DegreesPerUnit = 1e-7;
    private const double MetresPerUnit = 1e-4;

    /// <summary>Who is to execute it.</summary>
    public MavlinkAddress Target { get; init; }

    /// <summary>Which command.</summary>
    public MavCmd Command { get; init; }

    /// <summary>Which of the two messages may carry it, and which is tried first.</summary>
    public MavlinkCommandForms Forms { get; init; }

    /// <summary>
    /// Whether <see cref="X"/>, <see cref="Y"/> and <see cref="Z"/> are a location in <see cref="Frame"/>:
    /// <c>hasLocation</c> in the definition of the command.
    /// </summary>
    public bool HasLocation { get; init; }

    /// <summary>The coordinate frame of the location; it is sent in COMMAND_INT only.</summary>
    public MavFrame Frame { get; init; }

    /// <summary>Parameter 1, in the unit of the command.</summary>
    public float Param1 { get; init; }

    /// <summary>Parameter 2, in the unit of the command.</summary>
    public float Param2 { get; init; }

    /// <summary>Parameter 3, in the unit of the command.</summary>
    public float Param3 { get; init; }

    /// <summary>Parameter 4, in the unit of the command.</summary>
    public float Param4 { get; init; }

    /// <summary>Parameter 5 of a command without a location; <see cref="X"/> of one that has it.</summary>
    public float Param5 { get; init; }

    /// <summary>Parameter 6 of a command without a location; <see cref="Y"/> of one that has it.</summary>
    public float Param6 { get; init; }

    /// <summary>
    /// Parameter 7, in the unit of the command; of a location its altitude, which is <see cref="Z"/>.
    /// </summary>
    public float Param7 { get; init; }

    /// <summary>Of a location (parameter 5): latitude in 1e-7 degrees, or metres * 1e4 in a local frame.</summary>
    public int X { get; init; }

    /// <summary>Of a location (parameter 6): longitude in 1e-7 degrees, or metres * 1e4 in a local frame.</summary>
    public int Y { get; init; }

    /// <summary>
    /// Of a location: altitude in metres, in its frame. Another name of <see cref="Param7"/>, which COMMAND_INT calls
    /// z.
    /// </summary>
    public float Z
    {
        get => Param7;
        init => Param7 = value;
    }

    /// <summary>A command whose parameters are plain numbers, as COMMAND_LONG first.</summary>
    /// <param name="target">Who is to execute it.</param>
    /// <param name="command">Which command.</param>
    /// <param name="param1">Parameter 1.</param>
    /// <param name="param2">Parameter 2.</param>
    /// <param name="param3">Parameter 3.</param>
    /// <param name="param4">Parameter 4.</param>
    /// <param name="param5">Parameter 5.</param>
    /// <param name="param6">Parameter 6.</param>
    /// <param name="param7">Parameter 7.</param>
    /// <returns>The command.</returns>
    public static MavlinkCommand Create(
        MavlinkAddress target, MavCmd command, float param1 = 0, float param2 = 0, float param3 = 0, float param4 = 0,
        float param5 = 0, float param6 = 0, float param7 = 0)
            => new()
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
                Param7 = param7,
            };

    /// <summary>
    /// A command with a location, as COMMAND_INT first: the single-precision degrees of COMMAND_LONG are no better than
    /// a metre.
    /// </summary>
    /// <param name="target">Who is to execute it.</param>
    /// <param name="command">Which command.</param>
    /// <param name="frame">What <paramref name="z"/> counts from.</param>
    /// <param name="x">Latitude in 1e-7 degrees, or metres * 1e4 in a local frame.</param>
    /// <param name="y">Longitude in 1e-7 degrees, or metres * 1e4 in a local frame.</param>
    /// <param name="z">Altitude in metres.</param>
    /// <param name="param1">Parameter 1.</param>
    /// <param name="param2">Parameter 2.</param>
    /// <param name="param3">Parameter 3.</param>
    /// <param name="param4">Parameter 4.</param>
    /// <returns>The command.</returns>
    public static MavlinkCommand AtLocation(
        MavlinkAddress target, MavCmd command, MavFrame frame, int x, int y, float z, float param1 = 0,
        float param2 = 0, float param3 = 0, float param4 = 0)
            => new()
            {
                Target = target,
                Command = command,
                Forms = MavlinkCommandForms.IntThenLong,
                HasLocation = true,
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
        Param5 = HasLocation ? ToFloat(X) : Param5,
        Param6 = HasLocation ? ToFloat(Y) : Param6,
        Param7 = Param7,
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
        X = HasLocation ? X : ToInteger(Param5),
        Y = HasLocation ? Y : ToInteger(Param6),
        Z = Z,
    };

    internal static MavlinkCommand From(in CommandLong message) => Create(
        new MavlinkAddress(message.TargetSystem, message.TargetComponent), message.Command, message.Param1,
        message.Param2, message.Param3, message.Param4, message.Param5, message.Param6, message.Param7) with
    {
        Forms = MavlinkCommandForms.LongOnly,
    };

    internal static MavlinkCommand From(in CommandInt message) => AtLocation(
        new MavlinkAddress(message.TargetSystem, message.TargetComponent), message.Command, message.Frame, message.X,
        message.Y, message.Z, message.Param1, message.Param2, message.Param3, message.Param4) with
    {
        Forms = MavlinkCommandForms.IntOnly,
        Param5 = message.X,
        Param6 = message.Y,
    };

    // The max integer is "not given", as NaN is for floats.
    private float ToFloat(int value)
        => value == int.MaxValue ? float.NaN : (float)(value * (IsLocal ? MetresPerUnit : DegreesPerUnit));

    private static int ToInteger(float value) => float.IsNaN(value) ? int.MaxValue
        : value >= int.MaxValue ? int.MaxValue
        : value <= int.MinValue ? int.MinValue
        : (int)Math.Round(value);

    private bool IsLocal
        => Frame is MavFrame.LocalNed or MavFrame.LocalEnu or MavFrame.LocalOffsetNed or MavFrame.BodyNed
            or MavFrame.BodyOffsetNed
            or MavFrame.BodyFrd or MavFrame.LocalFrd or MavFrame.LocalFlu;
}
