namespace UavConsole;

/// <summary>How inks of the map look in markup.</summary>
internal static class ScreenInk
{
    public static string Style(MapInk ink) => ink switch
    {
        MapInk.Lane => "grey35",
        MapInk.Area => "grey62",
        MapInk.Path => "deepskyblue1",
        MapInk.Ellipse => "grey74",
        MapInk.Home => "bold white",
        MapInk.Tentative => "grey74",
        MapInk.Red => "bold red",
        MapInk.Orange => "bold darkorange",
        MapInk.Blue => "bold dodgerblue1",
        MapInk.Yellow => "bold yellow",
        MapInk.Magenta => "bold magenta1",
        MapInk.Vehicle => "bold lime",
        MapInk.Frame => "grey",
        _ => "default",
    };
}
