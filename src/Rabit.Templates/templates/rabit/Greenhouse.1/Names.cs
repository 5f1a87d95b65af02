namespace Greenhouse._1;

/// <summary>What managers meet through: a message or queue is found by its name and type.</summary>
public static class Names
{
    /// <summary>Message: <see cref="AirTemperature"/>, from <see cref="Equipment"/>.</summary>
    public const string Air = "air";

    /// <summary>Queue: <see cref="WindowCommand"/>, to <see cref="Equipment"/>.</summary>
    public const string WindowCommands = "window commands";
}
