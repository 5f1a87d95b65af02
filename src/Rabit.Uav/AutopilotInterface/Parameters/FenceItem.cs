using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>One item of a fence, as the mission protocol carries it; enough to send it back unchanged.</summary>
internal readonly record struct FenceItem(
    MavCmd Command, MavFrame Frame, float Param1, float Param2, float Param3, float Param4, int X, int Y, float Z)
{
    public static FenceItem From(in MissionItemInt item) => new(
        item.Command, item.Frame, item.Param1, item.Param2, item.Param3, item.Param4, item.X, item.Y, item.Z);

    public MissionItemInt ToItem() => new()
    {
        Command = Command,
        Frame = Frame,
        Param1 = Param1,
        Param2 = Param2,
        Param3 = Param3,
        Param4 = Param4,
        X = X,
        Y = Y,
        Z = Z,
        Autocontinue = 1,
    };
}
