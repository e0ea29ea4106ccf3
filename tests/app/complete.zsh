# What zsh offers for a line: zsh -f complete.zsh FOLDER LINE. The folder has `_cnrg`, and the program is on PATH. A
# second shell has the line typed in, on a terminal of its own; whatever it adds as a match goes to a file.
zmodload zsh/zpty
folder=$1 line=$2 offered=$(mktemp)
zpty typed zsh -f -i
zpty -w typed "PS1= PS2=; cd ${(q)folder}; fpath=(\$PWD \$fpath); autoload -Uz compinit; compinit -D -u"
zpty -w typed "compadd() {
  [[ \${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]] && { builtin compadd \"\$@\"; return }
  local -a hits; builtin compadd -O hits \"\$@\"; print -rl -- \$hits >> $offered; builtin compadd \"\$@\" }"
zpty -w typed "comppostfuncs=(finished); finished() { print end >> $offered }; print ready > $offered"
until grep -qs ready $offered; do zpty -rt typed > /dev/null; sleep 0.02; done
zpty -n -w typed "$line"$'\t'
for _ in {1..500}; do
  grep -q '^end$' $offered && break
  zpty -rt typed > /dev/null
  sleep 0.02
done
grep -v '^ready$\|^end$\|^$' $offered | sort -u
zpty -d typed
rm $offered
