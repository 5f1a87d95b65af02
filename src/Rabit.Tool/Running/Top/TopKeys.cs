using System;

namespace Rabit.Tool.Running.Top;

/// <summary>What the keys do.</summary>
internal sealed class TopKeys(TopSettings settings)
{
    /// <summary>The last line of the screen.</summary>
    public const string Help =
        "q quit  / filter  0-3 all, managers, queues, messages  s n r l t sort by start, name, rate, load, trouble  "
            + "v reverse";

    private const int Page = 10;

    /// <returns>False when the program is to end.</returns>
    public bool Press(ConsoleKeyInfo key)
    {
        if (settings.IsTyping)
            Type(key);
        else if (key.KeyChar is 'q' or 'Q')
            return false;
        else if (key.KeyChar >= '0' && key.KeyChar <= '3')
            (settings.Section, settings.Scroll) = ((TopSection)(key.KeyChar - '0'), 0);
        else
            Command(key);
        return true;
    }

    private void Command(ConsoleKeyInfo key)
    {
        switch (key.Key, char.ToLowerInvariant(key.KeyChar))
        {
            case (_, 's'):
                settings.Order = TopOrder.Start;
                break;
            case (_, 'n'):
                settings.Order = TopOrder.Name;
                break;
            case (_, 'r'):
                settings.Order = TopOrder.Rate;
                break;
            case (_, 'l'):
                settings.Order = TopOrder.Load;
                break;
            case (_, 't'):
                settings.Order = TopOrder.Trouble;
                break;
            case (_, 'v'):
                settings.IsReversed = !settings.IsReversed;
                break;
            case (_, '/'):
                settings.IsTyping = true;
                break;
            case (ConsoleKey.Escape, _):
                settings.Filter = string.Empty;
                break;
            default:
                Scroll(key.Key);
                break;
        }
    }

    private void Scroll(ConsoleKey key)
    {
        settings.Scroll = key switch
        {
            ConsoleKey.UpArrow => Math.Max(0, settings.Scroll - 1),
            ConsoleKey.DownArrow => settings.Scroll + 1,
            ConsoleKey.PageUp => Math.Max(0, settings.Scroll - Page),
            ConsoleKey.PageDown => settings.Scroll + Page,
            ConsoleKey.Home => 0,
            _ => settings.Scroll,
        };
    }

    private void Type(ConsoleKeyInfo key)
    {
        switch (key.Key)
        {
            case ConsoleKey.Enter:
                settings.IsTyping = false;
                break;
            case ConsoleKey.Escape:
                (settings.IsTyping, settings.Filter) = (false, string.Empty);
                break;
            case ConsoleKey.Backspace:
                if (settings.Filter.Length > 0)
                    settings.Filter = settings.Filter[..^1];
                break;
            default:
                if (!char.IsControl(key.KeyChar) && settings.Filter.Length < 40)
                    settings.Filter += key.KeyChar;
                break;
        }

        settings.Scroll = 0;
    }
}
