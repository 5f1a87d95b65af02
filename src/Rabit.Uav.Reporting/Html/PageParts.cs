using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>What the page of one vehicle and that of a group are made of alike.</summary>
internal static class PageParts
{
    /// <summary>A line of a list of facts.</summary>
    public static PageWriter Fact(this PageWriter page, string name, string value)
        => page.Element("dt", name).Element("dd", value);

    /// <summary>The head of a table.</summary>
    /// <param name="page">The page.</param>
    /// <param name="names">Of the columns; one with a # before it is of numbers.</param>
    public static PageWriter TableHead(this PageWriter page, params string[] names)
    {
        page.Open("thead").Open("tr");
        foreach (string name in names)
            page.Element("th", name.TrimStart('#'), "scope", "col", "class", name[0] == '#' ? "number" : string.Empty);
        return page.Close().Close();
    }

    /// <summary>Begins the card of a target with its heading; the card stays open.</summary>
    /// <param name="page">The page.</param>
    /// <param name="kind">How it is marked.</param>
    /// <param name="name">Of the target, or the number of its track.</param>
    /// <param name="targetClass">Its class.</param>
    /// <param name="state">What became of it, one word or two.</param>
    public static PageWriter OpenTargetCard(
        this PageWriter page, string kind, string name, TargetClassName targetClass, string state)
    {
        page.Open("article", "class", "card target " + kind).Open("h3");
        page.Element("i", string.Empty, "class", "swatch", "style", "background:" + TargetClassNames.Css(targetClass));
        return page.Text(name + " ").Element("small", TargetClassNames.Name(targetClass))
            .Element("b", state, "class", "state").Close();
    }
}
